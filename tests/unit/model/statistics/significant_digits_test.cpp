#include "model/statistics/significant_digits.hpp"

#include <limits>

#include "tests/support/catch.hpp"

using namespace wheelwright;

TEST_CASE("A number in a sentence has so many digits and no exponent where a person writes none") {
  CHECK(in_digits(0.0, 2) == "0");
  CHECK(in_digits(7.43, 2) == "7.4");
  CHECK(in_digits(70.0, 3) == "70");
  CHECK(in_digits(0.00123, 2) == "0.0012");
  CHECK(in_digits(137.4, 2) == "140");
  CHECK(in_digits(-137.4, 2) == "-140");
  CHECK(in_digits(99.6, 2) == "100");
  CHECK(in_digits(995.0, 2) == "1000");
  CHECK(in_digits(2430.7, 3) == "2430");
  CHECK(in_digits(123456.0, 3) == "123000");
  CHECK(in_digits(9.96, 2) == "10");
  CHECK(in_digits(0.999, 2) == "1");
  CHECK(in_digits(0.04, 1) == "0.04");
  CHECK(in_digits(-0.3, 1) == "-0.3");
}

TEST_CASE("Zero has no sign, and what is tiny, huge or no number is written as such") {
  CHECK(in_digits(-0.0, 2) == "0");
  CHECK(in_digits(0.00005, 2) == "5e-05");
  CHECK(in_digits(999999.7, 3) == "1e+06");
  CHECK(in_digits(2.5e7, 2) == "2.5e+07");
  CHECK(in_digits(std::numeric_limits<double>::infinity(), 2) == "inf");
}
