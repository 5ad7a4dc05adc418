// The hybrid filter as the brain uses it, on drives of the simulated robot.
#include <cmath>
#include <optional>

#include "model/simulation/odometry.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/fault_scenario.hpp"

using namespace wheelwright;

namespace {

const RobotModel& model() {
  static const RobotModel made = test::calibrated_model("default", "box", 61);
  return made;
}

const test::RecordedDrive& drive() {
  static const test::RecordedDrive made =
      test::record_drive(test::robot_on_endless_floor("default", 61), 62, 60.0);
  return made;
}

}  // namespace

TEST_CASE("While all is well the hybrid pose is that of odometry to a centimetre") {
  HybridFilter filter(model());
  Odometry odometry(model().linear_part.wheel_base_m, model().encoder_scale->metres_per_tick);
  for (const SensorFrame& frame : drive().frames) {
    if (frame.valid) odometry.update(frame.ticks);
    filter.step(frame);
  }
  CHECK(distance_between_m(filter.pose(), odometry.pose()) < 0.01);
}

TEST_CASE("The same frames give the same output to the bit") {
  HybridFilter first(model());
  HybridFilter second(model());
  for (const SensorFrame& frame : drive().frames) {
    const HybridOutput a = first.step(frame);
    const HybridOutput b = second.step(frame);
    REQUIRE(a.pose.x_m == b.pose.x_m);
    REQUIRE(a.pose.theta_rad == b.pose.theta_rad);
    REQUIRE(a.covariance == b.covariance);
  }
}

TEST_CASE("The covariance is symmetric, positive and grows with the way, faster while a wheel is not heard") {
  HybridFilter filter(model());
  HybridFilter deaf(model());
  Eigen::Matrix3d received = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d not_received = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < drive().frames.size(); ++k) {
    SensorFrame frame = drive().frames[k];
    received = filter.step(frame).covariance;
    frame.valid = frame.valid && k < 2500;
    not_received = deaf.step(frame).covariance;
    REQUIRE((received - received.transpose()).norm() < 1e-12);
    REQUIRE(received.diagonal().minCoeff() >= 0.0);
    REQUIRE(received(0, 0) * received(1, 1) >= received(0, 1) * received(0, 1) - 1e-15);
  }
  CHECK(received(0, 0) > 0.0);
  CHECK(not_received(2, 2) > received(2, 2));
  CHECK(not_received(0, 0) + not_received(1, 1) > received(0, 0) + received(1, 1));
}

TEST_CASE("Frames that never came are bridged by the model without an alarm") {
  HybridFilter filter(model());
  HybridFilter patchy(model());
  for (std::size_t k = 0; k < drive().frames.size(); ++k) {
    const SensorFrame& frame = drive().frames[k];
    filter.step(frame);
    // Every tenth tick is left out, every seventh is not received.
    if (k % 10 == 9) continue;
    SensorFrame silent = frame;
    if (k % 7 == 6) silent.valid = false;
    const HybridOutput out = patchy.step(silent);
    REQUIRE(out.events.empty());
  }
  CHECK(distance_between_m(filter.pose(), patchy.pose()) < 0.02);
}

TEST_CASE("A model without encoder scale is refused") {
  RobotModel bare = model();
  bare.encoder_scale.reset();
  CHECK_THROWS_AS(HybridFilter(bare), std::invalid_argument);
}

TEST_CASE("Another floor calls for a recalibration, but not while the robot stands") {
  const auto change = [](simulation::SimulatedRobot& robot, int tick) {
    if (tick != 2500) return;
    robot.inject(
        {.kind = simulation::Fault::Kind::change_floor,
         .surface = {.grip = 0.55, .creep_per_n = 0.006, .rolling_drag = 0.03, .scrub_factor = 8.0}});
  };
  const auto carpet = test::record_drive(test::robot_on_endless_floor("default", 63), 63, 65.0, change);
  HybridFilter filter(model());
  for (std::size_t k = 0; k < carpet.frames.size(); ++k) {
    const HybridOutput out = filter.step(carpet.frames[k]);
    if (k < 2500) REQUIRE_FALSE(out.recalibration_due);
    REQUIRE(out.events.empty());
  }
  CHECK(filter.environment().recalibration_due());

  // Motors that draw current while the robot stands are no floor.
  HybridFilter standing(model());
  for (const SensorFrame& frame : drive().frames) standing.step(frame);
  SensorFrame rest = drive().frames.back();
  rest.motor_current_a = {0.3, 0.3};
  for (int k = 0; k < 2000; ++k) {
    ++rest.tick;
    REQUIRE_FALSE(standing.step(rest).recalibration_due);
  }
}

TEST_CASE("A stop does not bring into the pose what a faulty encoder has not counted") {
  HybridFilter filter(model());
  const auto& frames = drive().frames;
  constexpr std::size_t frozen_from = 1000;
  constexpr std::size_t stopped_from = 1150;
  const std::int64_t stays = frames[frozen_from].ticks.left;
  WheelTicks at_stop;
  Pose before_stop;
  double driven_m = 0.0;
  std::optional<double> kept_out_m;
  for (std::size_t k = 0; k < stopped_from + 60; ++k) {
    SensorFrame frame = frames[k];
    if (k == stopped_from) {
      at_stop = frame.ticks;
      before_stop = filter.pose();
      driven_m = model().encoder_scale->metres_per_tick.left * static_cast<double>(frame.ticks.left - stays);
    }
    if (k >= stopped_from) {
      frame.ticks = at_stop;
      frame.command = {};
      frame.command.tick = frame.tick;
      frame.armed = false;
    }
    if (k >= frozen_from) frame.ticks.left = stays;
    for (const FaultEvent& event : filter.step(frame).events) {
      if (event.stage == FaultEvent::Stage::ended && event.wheel == FaultyWheel::left)
        kept_out_m = event.size;
    }
  }
  REQUIRE(std::abs(driven_m) > 0.2);
  REQUIRE(kept_out_m);
  CHECK_THAT(*kept_out_m, Catch::Matchers::WithinAbs(-driven_m, 0.05));
  CHECK(distance_between_m(filter.pose(), before_stop) < 0.04);  // it rolls out
}
