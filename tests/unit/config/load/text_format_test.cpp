#include "config/load/text_format.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::config;

TEST_CASE("No number is written with the sign of a zero") {
  CHECK(plain_number(-0.0) == "0");
  CHECK(plain_number(0.0) == "0");
  CHECK(plain_number(-0.5) == "-0.5");
  CHECK(fixed_number(-0.0004, 3) == "0.000");
  CHECK(fixed_number(-0.0006, 3) == "-0.001");
}
