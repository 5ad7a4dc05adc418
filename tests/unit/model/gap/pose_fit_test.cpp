// A model from commands and reference poses, of robots whose numbers are known.
#include <array>
#include <cmath>
#include <deque>
#include <random>

#include "model/gap/pose_fit.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double given_base_m = 0.24;

struct Robot {
  double left_gain = 0.97;
  double right_gain = 1.02;
  double delay_s = 0.05;
  double lag_s = 0.11;  // of both motors
  double base_m = 0.262;

  // A motor that follows from one step of 1 ms to the next lags one step less.
  double whole_lag_s() const { return delay_s + lag_s - 1e-3; }
};

struct Drive {
  double period_s = 0.02;
  double seconds = 60.0;
  bool turns = true;
  int every = 5;  // rows for a pose
};

// In steps of 1 ms. Motors are pushed by noise; the reference errs by 1 mm and 2 mrad.
DriveLog driven(const Robot& robot, const Drive& drive, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  std::uniform_real_distribution<double> speed(-0.2, 0.25);
  DriveLog log;
  log.name = "run" + std::to_string(seed);
  log.wheel_base_m = given_base_m;
  log.period_s = drive.period_s;
  const int steps = static_cast<int>(std::lround(1000.0 * drive.period_s));
  std::deque<WheelPair> sent(static_cast<std::size_t>(std::lround(1000.0 * robot.delay_s)));
  WheelPair command;
  WheelPair wheels;
  Pose pose;
  const int rows = static_cast<int>(drive.seconds / drive.period_s);
  const int hold = static_cast<int>(0.8 / drive.period_s);
  for (int k = 0; k < rows; ++k) {
    if (k % hold == 0) {
      command = k < hold ? WheelPair{} : WheelPair{speed(random), speed(random)};
      if (!drive.turns) command.right = command.left;
    }
    DriveSample sample;
    sample.t_s = drive.period_s * k;
    sample.command_m_s = command;
    if (k % drive.every == 0) {
      sample.reference_x_m = pose.x_m + 1e-3 * noise(random);
      sample.reference_y_m = pose.y_m + 1e-3 * noise(random);
      sample.reference_theta_rad = wrap_angle(pose.theta_rad + 2e-3 * noise(random));
    }
    log.samples.push_back(sample);
    const WheelPair pushed{3e-3 * noise(random), 3e-3 * noise(random)};
    for (int step = 0; step < steps; ++step) {
      sent.push_back(command);
      const WheelPair now = sent.front();
      sent.pop_front();
      wheels.left += 1e-3 / robot.lag_s * (robot.left_gain * now.left - wheels.left);
      wheels.right += 1e-3 / robot.lag_s * (robot.right_gain * now.right - wheels.right);
      const double left_m = 1e-3 * (wheels.left + pushed.left);
      const double right_m = 1e-3 * (wheels.right + pushed.right);
      pose = move_along_arc(pose, {0.5 * (left_m + right_m), (right_m - left_m) / robot.base_m}, 1.0);
    }
  }
  return log;
}

tl::expected<PoseFit, Refusal> fitted(const std::vector<DriveLog>& logs) {
  return fit_from_poses(logs, serial_for, [](const std::string&, double) {});
}

bool holds(const Estimate& estimate, double truth) {
  return estimate.interval.lower <= truth && truth <= estimate.interval.upper;
}

}  // namespace

TEST_CASE("Gains, lag and wheel base by poses alone are within their intervals, which are narrow") {
  const Robot robot;
  int held = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto fit = fitted({driven(robot, {}, 2 * seed), driven(robot, {}, 2 * seed + 1)});
    REQUIRE(fit);
    const std::array<std::pair<Estimate, double>, 4> figures{{{fit->left_gain, robot.left_gain},
                                                              {fit->right_gain, robot.right_gain},
                                                              {fit->lag_s, robot.whole_lag_s()},
                                                              {fit->wheel_base_m, robot.base_m}}};
    for (const auto& [estimate, truth] : figures) {
      INFO(truth << ": " << estimate.interval.lower << " to " << estimate.interval.upper);
      CHECK_THAT(estimate.value, WithinRel(truth, 0.05));
      CHECK(estimate.interval.upper - estimate.interval.lower < 0.1 * truth);
      held += holds(estimate, truth) ? 1 : 0;
    }
    CHECK(fit->linear_part.wheel_base_m == fit->wheel_base_m.value);
  }
  CHECK(held >= 17);  // of 20
}

TEST_CASE("A long delay is found by poses alone") {
  const Robot robot{.delay_s = 0.3};
  const auto fit = fitted({driven(robot, {}, 31), driven(robot, {}, 32)});
  REQUIRE(fit);
  CHECK_THAT(fit->lag_s.value, WithinAbs(robot.whole_lag_s(), 0.02));
}

TEST_CASE("Poses of runs that never turn do not show the wheel base, which is said") {
  const auto fit = fitted({driven({}, {.turns = false}, 41)});
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason, ContainsSubstring("add a run that turns"));
}

TEST_CASE("Runs of periods that are near are fitted together, on the shorter one") {
  const Robot robot;
  const auto fit =
      fitted({driven(robot, {.period_s = 0.025, .every = 4}, 51), driven(robot, {.period_s = 0.02}, 52)});
  REQUIRE(fit);
  CHECK(fit->linear_part.period_s == 0.02);
  CHECK_THAT(fit->lag_s.value, WithinAbs(robot.whole_lag_s(), 0.01));
  CHECK_THAT(fit->wheel_base_m.value, WithinRel(robot.base_m, 0.02));
}
