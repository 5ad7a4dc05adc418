#include "model/statistics/order_statistics.hpp"

#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

TEST_CASE("The median is the value in the middle, of an even number the upper one of two") {
  CHECK(median({3.0}) == 3.0);
  CHECK(median({5.0, 1.0, 3.0}) == 3.0);
  CHECK(median({4.0, 1.0, 3.0, 2.0}) == 3.0);
}

TEST_CASE("A quantile is one of the values, and as large a share of the others is below it") {
  std::mt19937 random(1);
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  std::shuffle(values.begin(), values.end(), random);
  for (const int percent : {0, 5, 50, 95, 100}) CHECK(quantile(values, 0.01 * percent + 1e-9) == percent);
  CHECK(quantile({7.0}, 0.3) == 7.0);
}

TEST_CASE("The median size of normal deviations gives their standard deviation") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 3.0);
  std::vector<double> sizes;
  for (int i = 0; i < 20000; ++i) sizes.push_back(std::abs(normal(random)));
  CHECK_THAT(deviations_of_median_size * median(sizes), WithinAbs(3.0, 0.1));
}
