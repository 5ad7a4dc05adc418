#include "model/route/route_follower.hpp"

#include <algorithm>
#include <cmath>

#include "model/simulation/motion_predictor.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// A robot that answers with a dead time of two periods and a lag, as a model.
LinearModel lagging_model() {
  LinearModel model;
  double tap = 0.2;
  for (int i = 0; i < 30; ++i) {
    const double weight = i < 2 ? 0.0 : (tap *= 0.8);
    model.left.from_left.push_back(weight);
    model.right.from_right.push_back(weight);
    model.left.from_right.push_back(0.0);
    model.right.from_left.push_back(0.0);
  }
  const double gain = dc_gain(model.left).from_left;
  for (auto* wheel : {&model.left.from_left, &model.right.from_right}) {
    for (double& weight : *wheel) weight /= gain;
  }
  return model;
}

// Whose tyres take `dry_rad_s` of any turn rate.
RobotModel scrubbing_model(double dry_rad_s) {
  RobotModel model;
  model.linear_part = lagging_model();
  model.effects.emplace_back().setting = {"turn_scrub", "", {0.0, 0.0, dry_rad_s}};
  return model;
}

struct Drive {
  Pose end;
  bool finished = false;
  double farthest_from_checkpoint_m = 0.0;
  double largest_wheel_speed_m_s = 0.0;
  double slowest_moving_m_s = 1.0;
  double duration_s = 0.0;
};

Drive follow(const Route& route) {
  MotionPredictor robot(lagging_model());
  RouteFollower follower(route, {});
  std::vector<double> nearest(route.checkpoints.size(), 1e9);
  Drive drive;
  int ticks = 0;
  for (; ticks < 20000 && !follower.finished(); ++ticks) {
    const WheelPair speed = follower.steer(robot.rest_pose());
    robot.step(robot.command_for(speed));
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const auto& checkpoint = route.checkpoints[i];
      nearest[i] = std::min(nearest[i],
                            std::hypot(robot.pose().x_m - checkpoint.x_m, robot.pose().y_m - checkpoint.y_m));
    }
    const double fastest = std::max(std::abs(speed.left), std::abs(speed.right));
    drive.largest_wheel_speed_m_s = std::max(drive.largest_wheel_speed_m_s, fastest);
    if (fastest > 0.0) drive.slowest_moving_m_s = std::min(drive.slowest_moving_m_s, fastest);
  }
  for (int k = 0; k < 60; ++k) robot.step({});
  drive.end = robot.pose();
  drive.finished = follower.finished();
  drive.farthest_from_checkpoint_m = *std::max_element(nearest.begin(), nearest.end());
  drive.duration_s = 0.018 * ticks;
  return drive;
}

}  // namespace

TEST_CASE("A square is driven through its corners and ends where it began") {
  const Route square{"square", 0.2, 0.01, {{1, 0}, {1, 1}, {0, 1}, {0, 0}}};
  const Drive drive = follow(square);
  REQUIRE(drive.finished);
  CHECK(std::hypot(drive.end.x_m, drive.end.y_m) < 0.003);
  CHECK(drive.farthest_from_checkpoint_m < 0.01);
  CHECK(drive.duration_s < 45.0);
}

TEST_CASE("A figure of eight is driven without stopping at its checkpoints") {
  Route eight{"eight", 0.2, 0.03, {}};
  for (const double side : {1.0, -1.0}) {
    for (int i = 1; i <= 16; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / 16.0;
      eight.checkpoints.push_back({0.5 * std::sin(angle), side * 0.5 * (1.0 - std::cos(angle))});
    }
  }
  eight.checkpoints.back() = {0.0, 0.0};
  const Drive drive = follow(eight);
  REQUIRE(drive.finished);
  CHECK(drive.farthest_from_checkpoint_m < 0.03);
  CHECK(std::hypot(drive.end.x_m, drive.end.y_m) < 0.03);
  // 6.28 m at 0.2 m/s take 31 s; stops would add seconds each.
  CHECK(drive.duration_s < 40.0);
}

TEST_CASE("A checkpoint behind the robot is turned to on the spot") {
  const Drive drive = follow({"back", 0.15, 0.01, {{-0.5, 0.001}}});
  REQUIRE(drive.finished);
  CHECK_THAT(drive.end.x_m, WithinAbs(-0.5, 0.003));
  CHECK_THAT(std::abs(wrap_angle(drive.end.theta_rad)), WithinAbs(3.14159, 0.05));
}

TEST_CASE("A first checkpoint at the start is visited without moving there") {
  const Drive drive = follow({"start", 0.15, 0.01, {{0, 0}, {0.3, 0}, {0, 0}}});
  REQUIRE(drive.finished);
  CHECK(std::hypot(drive.end.x_m, drive.end.y_m) < 0.01);
}

TEST_CASE("No wheel is asked for more than its limit, nor for less than what moves it") {
  const Drive drive = follow({"fast", 0.3, 0.02, {{1, 0}, {0.5, 0.8}, {0, 0}}});
  CHECK(drive.largest_wheel_speed_m_s <= 0.3 + 1e-12);
  CHECK(drive.slowest_moving_m_s >= 0.039);
}

TEST_CASE("No wheel's speed jumps where the robot turns on its way") {
  const FollowerLimits limits;
  MotionPredictor robot(lagging_model());
  RouteFollower follower({"zigzag", 0.25, 0.02, {{0.6, 0.0}, {1.0, 0.38}, {1.6, 0.38}, {2.0, 0.0}}}, limits);
  WheelPair before;
  double largest_jump_m_s = 0.0;
  while (!follower.finished()) {
    const WheelPair speed = follower.steer(robot.rest_pose());
    const bool ahead = std::min({speed.left + speed.right, before.left + before.right}) > 0.0;
    const double jump_m_s =
        std::max(std::abs(speed.left - before.left), std::abs(speed.right - before.right));
    if (ahead) largest_jump_m_s = std::max(largest_jump_m_s, jump_m_s);
    robot.step(robot.command_for(speed));
    before = speed;
  }
  CHECK(largest_jump_m_s <= limits.largest_wheel_acceleration_m_s2 * limits.period_s + 1e-12);
  CHECK(largest_jump_m_s > 0.02);  // corners of 0.76 rad are there to be turned
}

TEST_CASE("Along the legs a robot with a dead band in turning is steered straight or turned clearly") {
  for (const double dry_rad_s : {0.02, 0.05, 0.1}) {
    MotionPredictor robot(scrubbing_model(dry_rad_s));
    const double band_rad_s = robot.limits().turn_dead_band_rad_s;
    // Half of twice what is lost is left.
    CHECK_THAT(band_rad_s, WithinAbs(2.0 * dry_rad_s, 0.011));
    RouteFollower follower({"loop", 0.2, 0.02, {{0.9, 0.0}, {1.5, 0.3}, {1.4, 1.4}, {0.1, 0.5}, {0.0, 0.0}}},
                           {});
    int straight = 0;
    int turned = 0;
    int passing = 0;  // from one to the other: no wheel's speed jumps
    for (int ticks = 0; ticks < 20000 && !follower.finished(); ++ticks) {
      const WheelPair speed = follower.steer(robot.rest_pose(), robot.limits());
      robot.step(robot.command_for(speed));
      if (speed.left <= 0.0 || speed.right <= 0.0) continue;
      const double turn_rad_s = std::abs(twist_of_wheels(speed, 0.235).w_rad_s);
      passing = turn_rad_s < 1e-9 || turn_rad_s > 2.0 * band_rad_s ? 0 : passing + 1;
      CHECK(passing <= 2);
      ++(turn_rad_s < 1e-9 ? straight : turned);
    }
    CHECK(follower.finished());
    CHECK(std::hypot(robot.pose().x_m, robot.pose().y_m) < 0.02);
    CHECK(straight > turned);
  }
}

TEST_CASE(
    "A dead band that is not what the model says moves the end of a drive less than in proportional "
    "steering") {
  const auto missed_by_m = [](double true_rad_s, bool steered_by_band) {
    MotionPredictor model(scrubbing_model(0.05));
    MotionPredictor robot(scrubbing_model(true_rad_s));
    RouteFollower follower({"legs", 0.2, 0.02, {{1.0, 0.1}, {2.0, 0.0}, {3.0, 0.1}, {4.0, 0.0}}}, {});
    for (int ticks = 0; ticks < 20000 && !follower.finished(); ++ticks) {
      const WheelPair command = model.command_for(
          follower.steer(model.rest_pose(), steered_by_band ? model.limits() : DriveLimits{}));
      model.step(command);
      robot.step(command);
    }
    CHECK(follower.finished());
    return std::hypot(robot.pose().x_m - model.pose().x_m, robot.pose().y_m - model.pose().y_m);
  };
  for (const double true_rad_s : {0.03, 0.04, 0.045, 0.055, 0.06, 0.07}) {
    CAPTURE(true_rad_s);
    CHECK(missed_by_m(true_rad_s, true) < missed_by_m(true_rad_s, false));
  }
}

TEST_CASE("A robot that follows small turn rates has no dead band in turning") {
  CHECK(MotionPredictor(lagging_model()).limits().turn_dead_band_rad_s == 0.0);
  CHECK(MotionPredictor(scrubbing_model(0.0)).limits().turn_dead_band_rad_s == 0.0);
}

TEST_CASE(
    "A robot that is slower than its route is driven below its fastest speed, where it can be steered") {
  RobotModel model;
  model.linear_part = lagging_model();
  model.effects.emplace_back().setting = {"saturation", "speed", {0.16, 0.0, 0.0}};
  MotionPredictor robot(model);
  CHECK_THAT(robot.limits().fastest_wheel_m_s, WithinAbs(0.16, 0.005));
  CHECK(robot.limits().turn_dead_band_rad_s == 0.0);
  RouteFollower follower({"loop", 0.25, 0.02, {{0.9, 0.0}, {1.5, 0.3}, {1.4, 1.4}, {0.1, 0.5}, {0.0, 0.0}}},
                         {});
  double fastest_m_s = 0.0;
  for (int ticks = 0; ticks < 20000 && !follower.finished(); ++ticks) {
    const WheelPair speed = follower.steer(robot.rest_pose(), robot.limits());
    fastest_m_s = std::max({fastest_m_s, speed.left, speed.right});
    robot.step(robot.command_for(speed));
  }
  CHECK(follower.finished());
  CHECK(fastest_m_s < robot.limits().fastest_wheel_m_s);
  CHECK(fastest_m_s > 0.9 * robot.limits().fastest_wheel_m_s);
}
