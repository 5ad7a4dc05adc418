#include "tools/wheelwright/import/conversion/stamps.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright::import;

namespace {

// Travel at a speed that sways slowly.
double travel_at(double t_s) {
  return 0.2 * t_s + 0.1 * std::sin(0.5 * t_s);
}

}  // namespace

TEST_CASE("Stamps in bunches are made even where the travel goes by rows") {
  std::vector<double> t_s, travel;
  double last = -1.0;
  for (int k = 0; k < 600; ++k) {
    const double measured_s = 0.033 * k;
    // Handled four rows at a time.
    double stamp = 0.033 * (k / 4 * 4 + 3) + 0.0007 * (k % 4);
    stamp = std::max(stamp, last + 1e-4);
    last = stamp;
    t_s.push_back(stamp);
    travel.push_back(travel_at(measured_s));
  }
  const auto even = even_stamps(t_s, travel);
  REQUIRE(even);
  CHECK_THAT(even->period_s, WithinAbs(0.033, 2e-4));
  for (std::size_t k = 1; k < even->t_s.size(); ++k) {
    CHECK_THAT(even->t_s[k] - even->t_s[k - 1], WithinAbs(0.033, 2e-4));
  }
}

TEST_CASE("Stamps are believed where the travel goes by them, however uneven they are") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step_s(0.01, 0.09);
  std::vector<double> t_s, travel;
  double t = 0.0;
  for (int k = 0; k < 600; ++k) {
    t_s.push_back(t);
    travel.push_back(travel_at(t));
    t += step_s(random);
  }
  CHECK_FALSE(even_stamps(t_s, travel));
}

TEST_CASE("Stamps with little jitter are left alone") {
  std::vector<double> t_s, travel;
  for (int k = 0; k < 600; ++k) {
    t_s.push_back(0.05 * k + 0.004 * std::sin(2.1 * k));
    travel.push_back(travel_at(0.05 * k));
  }
  CHECK_FALSE(even_stamps(t_s, travel));
}
