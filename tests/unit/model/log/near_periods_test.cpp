// Runs of one robot that were logged at different periods.
#include "model/log/near_periods.hpp"

#include "model/identification/fir_fit.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_run.hpp"

using namespace wheelwright;

namespace {

// A wheel with a lag of 0.1 s, logged at a period of its own.
DriveLog lagging(double period_s, unsigned seed) {
  constexpr double tick_m = 1e-6;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 0.2);
  DriveLog log;
  log.name = "run" + std::to_string(seed);
  log.wheel_base_m = 0.235;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{tick_m, tick_m};
  WheelPair speed;
  WheelPair travelled;
  WheelPair command;
  for (int k = 0; k < 3000; ++k) {
    if (k % 10 == 0) command = {normal(random), normal(random)};
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled.left / tick_m), std::llround(travelled.right / tick_m)};
    log.samples.push_back(sample);
    constexpr int steps = 20;
    for (int step = 0; step < steps; ++step) {
      const double dt = period_s / steps;
      speed.left += dt / 0.1 * (0.95 * command.left - speed.left);
      speed.right += dt / 0.1 * (1.05 * command.right - speed.right);
      travelled.left += dt * speed.left;
      travelled.right += dt * speed.right;
    }
  }
  return log;
}

}  // namespace

TEST_CASE("Periods are near where they change the delay by less than is of interest") {
  CHECK(are_near_periods(0.018, 0.0185));
  CHECK(are_near_periods(0.018, 0.025));
  CHECK(are_near_periods(0.1, 0.12));
  CHECK_FALSE(are_near_periods(0.018, 0.05));
  CHECK_FALSE(are_near_periods(0.2, 0.1));
}

TEST_CASE("Runs whose periods differ by a few percent are fitted together") {
  const std::vector<DriveLog> logs{lagging(0.0207, 1), lagging(0.02, 2)};
  CHECK_FALSE(find_far_period(logs));
  const auto fit = fit_fir(logs);
  REQUIRE(fit);
  CHECK(fit->model.period_s == 0.02);
  CHECK_THAT(fit->left.gain.from_left, WithinRel(0.95, 0.005));
  CHECK_THAT(fit->right.gain.from_right, WithinRel(1.05, 0.005));
}

TEST_CASE("Runs whose periods are far apart are refused, with both periods") {
  const std::vector<DriveLog> logs{lagging(0.02, 1), lagging(0.06, 2)};
  const auto fit = fit_fir(logs);
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason,
             ContainsSubstring("run2:1: its period is 0.06 s, but that of run1 is 0.02 s"));
}
