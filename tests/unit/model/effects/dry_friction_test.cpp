// Friction and stiction of a wheel, against its equation of motion.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/dry_friction_drive.hpp"
#include "tests/support/one_effect.hpp"

using namespace wheelwright;
using test::only;

namespace {

// A wheel with dry friction whose speed a controller with proportional and integral part holds: its equation
// of motion in small steps.
struct ControlledWheel {
  double friction_m_s = 0.0;
  double breakaway_m_s = 0.0;
  double speed_m_s = 0.0;
  double integral_m_s = 0.0;

  static constexpr double lag_s = 0.1;  // of the wheel without a controller
  static constexpr double proportional = 1.5;
  static constexpr double integral_per_s = 12.0;

  double moved_m(double command_m_s) {
    constexpr int steps = 400;
    constexpr double step_s = test::one_effect_period_s / steps;
    double way_m = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double error_m_s = command_m_s - speed_m_s;
      integral_m_s += integral_per_s * error_m_s * step_s;
      const double drive_m_s = proportional * error_m_s + integral_m_s;
      if (speed_m_s == 0.0 && std::abs(drive_m_s) <= breakaway_m_s) continue;
      const double direction = speed_m_s != 0.0 ? speed_m_s : drive_m_s;
      const double next_m_s =
          speed_m_s + step_s / lag_s * (drive_m_s - speed_m_s - std::copysign(friction_m_s, direction));
      speed_m_s = next_m_s * speed_m_s < 0.0 ? 0.0 : next_m_s;
      way_m += speed_m_s * step_s;
    }
    return way_m;
  }
};

}  // namespace

TEST_CASE("Friction that a controller makes up for is that of the wheel's own equation of motion") {
  const auto [name, breakaway_excess_m_s] =
      GENERATE(std::pair{"coulomb_friction", 0.0}, std::pair{"stiction", 0.2});
  constexpr double friction_m_s = 0.15;
  // By the proportional part the wheel is quicker, and gives way the less.
  constexpr double firmer = 1.0 + ControlledWheel::proportional;
  constexpr double lag_s = ControlledWheel::lag_s / firmer;
  constexpr double recovery_s = firmer / ControlledWheel::integral_per_s;
  std::vector<double> parameters{friction_m_s / firmer, lag_s, recovery_s};
  if (breakaway_excess_m_s > 0.0)
    parameters = {breakaway_excess_m_s / firmer, friction_m_s / firmer, lag_s, 0.0005, recovery_s};
  ModelSimulation simulation = only({name, "controlled", parameters});
  ControlledWheel free;
  ControlledWheel robot{.friction_m_s = friction_m_s, .breakaway_m_s = friction_m_s + breakaway_excess_m_s};
  double way_m = 0.0;
  double of_robot_m = 0.0;
  double lost_m = 0.0;
  for (int k = 0; k < 900; ++k) {
    const double command_m_s = k < 100 ? 0.2 : 0.25 * std::sin(0.03 * k);
    const double linear_m_s = free.moved_m(command_m_s) / test::one_effect_period_s;
    way_m += test::one_effect_period_s * simulation.step({linear_m_s, linear_m_s}).wheel_m_s.left;
    of_robot_m += robot.moved_m(command_m_s);
    lost_m = std::max(lost_m, std::abs(of_robot_m - way_m));
  }
  CHECK(lost_m < 0.001);
}

TEST_CASE("A change of direction under a controller costs a way that hangs on its integral part alone") {
  ModelSimulation simulation = only({"coulomb_friction", "controlled", {0.05, 0.03, 0.2}});
  const auto way_m = [&](double command_m_s, int periods) {
    double sum_m = 0.0;
    for (int k = 0; k < periods; ++k)
      sum_m += test::one_effect_period_s * simulation.step({command_m_s, 0.0}).wheel_m_s.left;
    return sum_m;
  };
  way_m(0.2, 400);
  CHECK_THAT(way_m(0.2, 1), WithinRel(0.2 * test::one_effect_period_s, 1e-6));
  CHECK_THAT(way_m(-0.2, 400), WithinAbs(-400 * test::one_effect_period_s * 0.2 + 2.0 * 0.05 * 0.2, 3e-4));
}

TEST_CASE("A wheel with stiction stands again at the speed below which friction has risen") {
  const auto stands_at = [](double sticking_m_s) {
    ModelSimulation simulation = only({"stiction", "", {0.03, 0.002, 0.01, sticking_m_s}});
    double moved_at = 0.0;
    for (int k = 0; k < 100; ++k) moved_at = simulation.step({0.05, 0.05}).wheel_m_s.left;
    for (double command = 0.05; command > 0.0; command -= 0.0001) {
      const double speed = simulation.step({command, command}).wheel_m_s.left;
      if (speed == 0.0) return moved_at;
      moved_at = speed;
    }
    return 0.0;
  };
  CHECK_THAT(stands_at(0.012), WithinAbs(0.012, 0.0005));
  CHECK_THAT(stands_at(0.004), WithinAbs(0.004, 0.0005));
}

TEST_CASE("In rows of 50 and 100 ms friction takes as much way as by the wheel's equation of motion") {
  const double period_s = GENERATE(0.05, 0.1);
  constexpr double friction_m_s = 0.03;
  const test::DryFrictionRobot motor{.gain = 1.0, .lag_s = 0.07};
  LinearModel passed_on{ModelType::fir, period_s, 0.25, {{1.0}, {0.0}, {}}, {{0.0}, {1.0}, {}}};
  ModelSimulation simulation(
      passed_on, std::vector<EffectSetting>{{"coulomb_friction", "", {friction_m_s, motor.lag_s}}});
  test::DryFrictionWheel free(motor);
  test::DryFrictionWheel robot(motor);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any_m_s(-0.25, 0.25);
  double command_m_s = 0.0;
  double free_m = 0.0;
  double off_squares = 0.0;
  double taken_squares = 0.0;
  constexpr int periods = 2000;
  for (int k = 0; k < periods; ++k) {
    if (k % 5 == 0) command_m_s = any_m_s(random);
    const double robot_before_m = robot.way_m();
    free.move(command_m_s, 0.0, period_s);
    robot.move(command_m_s, friction_m_s, period_s);
    const double free_m_s = (free.way_m() - std::exchange(free_m, free.way_m())) / period_s;
    const double robot_m_s = (robot.way_m() - robot_before_m) / period_s;
    const double speed_m_s = simulation.step({free_m_s, free_m_s}).wheel_m_s.left;
    off_squares += std::pow(speed_m_s - robot_m_s, 2);
    taken_squares += std::pow(free_m_s - robot_m_s, 2);
  }
  // Of what friction takes. With one step per period it is 0.30 and 0.36.
  CHECK(std::sqrt(off_squares / taken_squares) < 0.2);
}
