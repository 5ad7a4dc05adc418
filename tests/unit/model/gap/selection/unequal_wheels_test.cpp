// Wheels that are not alike: each has its own friction, dead zone or play, and the log shows how much.
#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double row_s = 0.02;
constexpr double base_m = 0.25;

// A motor without a controller, and behind a gear with play the wheel. Forces are accelerations, in m/s^2.
struct Gearmotor {
  double dry_friction_m_s2 = 0.0;
  double dead_below_m_s = 0.0;  // of the command; larger ones pass as they are
  double play_m = 0.0;

  double speed_m_s = 0.0;
  double motor_m = 0.0;
  double wheel_m = 0.0;

  void turn(double command_m_s, double step_s) {
    constexpr double lag_s = 0.08;
    const double drive_m_s = std::abs(command_m_s) < dead_below_m_s ? 0.0 : command_m_s;
    const double driven_m_s = speed_m_s + step_s * (drive_m_s - speed_m_s) / lag_s;
    const double braked_m_s = std::min(std::abs(driven_m_s), step_s * dry_friction_m_s2);
    speed_m_s = driven_m_s - std::copysign(braked_m_s, driven_m_s);
    motor_m += step_s * speed_m_s;
    wheel_m = std::clamp(wheel_m, motor_m - 0.5 * play_m, motor_m + 0.5 * play_m);
  }
};

struct Pair {
  Gearmotor left;
  Gearmotor right;
};

// Speeds that are held for half a second; encoders at the wheels, and a camera that errs by a millimetre.
DriveLog driven(Pair robot, unsigned seed) {
  constexpr double metres_per_tick = 2e-4;
  constexpr int steps = 20;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any_m_s(-0.25, 0.3);
  std::normal_distribution<double> errs(0.0, 1e-3);
  DriveLog log;
  log.name = "run" + std::to_string(seed);
  log.wheel_base_m = base_m;
  log.period_s = row_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  const auto ticks = [](double travel_m) { return std::lround(travel_m / metres_per_tick); };
  WheelPair command_m_s;
  Pose pose;
  for (int k = 0; k < 2250; ++k) {
    if (k % 25 == 0) command_m_s = {any_m_s(random), any_m_s(random)};
    DriveSample sample;
    sample.t_s = row_s * k;
    sample.command_m_s = command_m_s;
    sample.ticks = WheelTicks{ticks(robot.left.wheel_m), ticks(robot.right.wheel_m)};
    sample.reference_x_m = pose.x_m + errs(random);
    sample.reference_y_m = pose.y_m + errs(random);
    sample.reference_theta_rad = pose.theta_rad + 2.0 * errs(random);
    log.samples.push_back(sample);
    for (int step = 0; step < steps; ++step) {
      const WheelPair before{robot.left.wheel_m, robot.right.wheel_m};
      robot.left.turn(command_m_s.left, row_s / steps);
      robot.right.turn(command_m_s.right, row_s / steps);
      const WheelPair rolled_m{robot.left.wheel_m - before.left, robot.right.wheel_m - before.right};
      pose = move_along_arc(pose, twist_of_wheels(rolled_m, base_m), 1.0);
    }
  }
  return log;
}

GapAnalysis analysis_of(const Pair& robot) {
  std::vector<DriveLog> logs;
  for (unsigned seed = 1; seed <= 3; ++seed) logs.push_back(driven(robot, seed));
  const auto analysis = analyse_gap(std::span(logs).first(2), std::span(logs).last(1), {}, serial_for,
                                    [](const std::string&, double) {});
  REQUIRE(analysis);
  INFO(analysis->summary);
  return *analysis;
}

void check_sizes(const GapAnalysis& analysis, const std::string& effect, double left, double right) {
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  const Finding& found = analysis.found.front();
  CHECK(found.setting.name == effect);
  REQUIRE(found.setting.variant.ends_with("each_wheel"));
  CHECK_THAT(found.setting.parameters[0], Catch::Matchers::WithinRel(left, 0.1));
  CHECK_THAT(found.setting.parameters[1], Catch::Matchers::WithinRel(right, 0.1));
}

}  // namespace

TEST_CASE("Friction that is not alike at both wheels is one effect with a size for each wheel") {
  constexpr double lag_s = 0.08;
  const GapAnalysis analysis =
      analysis_of({{.dry_friction_m_s2 = 0.02 / lag_s}, {.dry_friction_m_s2 = 0.045 / lag_s}});
  check_sizes(analysis, "coulomb_friction", 0.02, 0.045);
}

TEST_CASE("Dead zones that are not alike are one effect with a threshold for each wheel") {
  const GapAnalysis analysis = analysis_of({{.dead_below_m_s = 0.04}, {.dead_below_m_s = 0.07}});
  check_sizes(analysis, "dead_zone", 0.04, 0.07);
}

TEST_CASE("Play at one wheel alone is play, and no castor that kicks the robot around on reversal") {
  const GapAnalysis analysis = analysis_of({{}, {.play_m = 0.006}});
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  const Finding& found = analysis.found.front();
  CHECK(found.setting.name == "backlash");
  REQUIRE(found.setting.variant.ends_with("each_wheel"));
  CHECK(found.setting.parameters[0] < 4e-4);
  CHECK_THAT(found.setting.parameters[1], Catch::Matchers::WithinRel(0.006, 0.05));
}

TEST_CASE("Wheels that are alike keep one size for both") {
  constexpr double lag_s = 0.08;
  const Gearmotor either{.dry_friction_m_s2 = 0.03 / lag_s};
  const GapAnalysis analysis = analysis_of({either, either});
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  CHECK(analysis.found.front().setting.name == "coulomb_friction");
  CHECK(analysis.found.front().setting.variant.empty());
}
