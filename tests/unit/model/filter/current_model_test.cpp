// What current a motor should draw, learnt while driving.
#include "model/filter/current_model.hpp"

#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// On a floor that slopes: friction, and gravity by heading.
double current_a(double speed_m_s, double heading_rad) {
  return std::copysign(0.1, speed_m_s) + 0.3 * speed_m_s + 0.05 * std::cos(heading_rad - 0.7);
}

}  // namespace

TEST_CASE("The current that a slope takes is expected at any heading") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> heading(-3.1, 3.1);
  std::uniform_real_distribution<double> speed(0.05, 0.25);
  CurrentModel model;
  for (int block = 0; block < 200; ++block) {
    const double v = block % 3 == 0 ? -speed(random) : speed(random);
    const double theta = heading(random);
    model.take(CurrentModel::features(v, 0.0, 0.0, theta), current_a(v, theta));
  }
  REQUIRE(model.ready());
  for (const double theta : {-2.5, -1.0, 0.0, 1.5, 3.0})
    CHECK_THAT(model.expected_a(CurrentModel::features(0.15, 0.0, 0.0, theta)),
               WithinAbs(current_a(0.15, theta), 0.002));
}

TEST_CASE("Where nothing like it was learnt, the expectation is less sure") {
  CurrentModel model;
  for (int block = 0; block < 100; ++block)
    model.take(CurrentModel::features(0.15 + 0.001 * (block % 10), 0.0, 0.0, 0.0), 0.15);
  const auto usual = CurrentModel::features(0.155, 0.0, 0.0, 0.0);
  const auto other = CurrentModel::features(-0.155, 0.0, 0.2, 2.0);
  CHECK(model.spread_a(other) > 5.0 * model.spread_a(usual));
}
