// The whole calibration on the virtual clock, judged by what only the simulator knows.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "daemon/replay/virtual_run.hpp"
#include "model/simulation/motion_predictor.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/simulated_run.hpp"

using namespace wheelwright;

namespace {

daemon::VirtualRunConfig calibration_only() {
  daemon::VirtualRunConfig config;
  config.mission.encoder_turn = EncoderTurnPlan{};
  config.mission.response = ResponsePlan{};
  return config;
}

}  // namespace

TEST_CASE("Metres per tick come out within half a per cent of the truth in three different rooms") {
  for (const std::string room : {"box", "furniture", "corner"}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      INFO(room << ", seed " << seed);
      simulation::SimulatedRobot robot(test::robot_in_room("default", room, seed));
      daemon::VirtualRunConfig config;
      config.mission.encoder_turn = EncoderTurnPlan{};
      const auto result = daemon::run_virtually(config, robot);
      REQUIRE(result.finished);
      const auto truth = robot.truth();
      const double true_scale = 0.5 * (truth.metres_per_tick_left + truth.metres_per_tick_right);
      const double found =
          0.5 * (result.encoder_scale->metres_per_tick.left + result.encoder_scale->metres_per_tick.right);
      CHECK_THAT(found / true_scale, WithinAbs(1.0, 0.005));
    }
  }
}

TEST_CASE("On a slope, down which the robot gets in each turn, metres per tick are right as well") {
  double largest_drift = 0.0;
  for (const double angle_rad : {0.4, 2.0, 3.5, 5.1}) {
    INFO("uphill at " << angle_rad);
    auto description = test::robot_in_room("perfect", "box", 1);
    for (auto* wheel : {&description.left, &description.right}) wheel->friction.coulomb_nm = 0.08;
    description.room.floor.slope_x = 0.03 * std::cos(angle_rad);
    description.room.floor.slope_y = 0.03 * std::sin(angle_rad);
    simulation::SimulatedRobot robot(description);
    daemon::VirtualRunConfig config;
    config.mission.encoder_turn = EncoderTurnPlan{};
    const auto result = daemon::run_virtually(config, robot);
    REQUIRE(result.finished);
    const auto truth = robot.truth();
    const double true_scale = 0.5 * (truth.metres_per_tick_left + truth.metres_per_tick_right);
    CHECK_THAT(result.encoder_scale->metres_per_tick.left / true_scale, WithinAbs(1.0, 0.002));
    largest_drift = std::max(largest_drift, std::abs(result.encoder_scale->drift.value()));
  }
  CHECK(largest_drift > 0.004);
}

TEST_CASE("Where the light bumper sees nothing the encoder calibration is refused with the reason") {
  simulation::SimulatedRobot robot(test::robot_in_room("default", "empty", 1));
  const auto result = daemon::run_virtually(calibration_only(), robot);
  CHECK_FALSE(result.finished);
  REQUIRE(result.refusal);
  CHECK_THAT(result.refusal->reason, ContainsSubstring("put an object"));
  CHECK(robot.truth().wheels_at_rest);
}

TEST_CASE("An encoder that ceases to count while the responses are measured is no gain of the robot") {
  simulation::SimulatedRobot robot(test::robot_in_room("default", "box_without_slip", 1));
  daemon::VirtualRunConfig config;
  config.mission.response = ResponsePlan{};
  const auto result =
      daemon::run_virtually(config, robot, [](simulation::SimulatedRobot& one, std::int64_t tick) {
        if (tick == 100)
          one.inject({.kind = simulation::Fault::Kind::freeze_encoder, .side = simulation::Side::right});
      });
  CHECK_FALSE(result.response);
  REQUIRE(result.refusal);
  CHECK_THAT(result.refusal->reason, ContainsSubstring("the right wheel counted "));
  CHECK(robot.truth().wheels_at_rest);
}

TEST_CASE("Swapped encoders are noticed by moving one wheel and put right") {
  auto description = test::robot_in_room("default", "box_without_slip", 1);
  description.encoder.swap_sides = true;
  simulation::SimulatedRobot robot(description);
  const auto result = daemon::run_virtually(calibration_only(), robot);
  CHECK(result.encoders_swapped);
  REQUIRE(result.finished);
  CHECK_THAT(result.response->left.gain.from_left, WithinAbs(1.0, 0.03));
  CHECK_THAT(result.response->left.gain.from_right, WithinAbs(0.0, 0.03));
}

TEST_CASE("On a robot without imperfections the FIR model predicts a random drive to under 5 per cent") {
  simulation::SimulatedRobot robot(test::robot_in_room("perfect", "box_without_slip", 1));
  const auto result = daemon::run_virtually(calibration_only(), robot);
  REQUIRE(result.finished);

  simulation::SimulatedRobot fresh(test::robot_in_room("perfect", "empty", 7));
  MotionPredictor predictor(result.response->model);
  const auto errors = test::drive_randomly(fresh, predictor, 3000, 11);
  CHECK(errors.command_rms_m_s > 0.1);
  CHECK(errors.speed_error_rms_m_s < 0.05 * errors.command_rms_m_s);
}

TEST_CASE("The same seed gives the same run, tick for tick, calibration included") {
  const auto run = [] {
    simulation::SimulatedRobot robot(test::robot_in_room("default", "box_without_slip", 5));
    auto config = calibration_only();
    config.mission.route = Route{"there and back", 0.15, 0.02, {{0.5, 0.0}, {0.0, 0.0}}};
    return daemon::run_virtually(config, robot);
  };
  const auto first = run();
  const auto second = run();
  REQUIRE(first.finished);
  REQUIRE(first.records.size() == second.records.size());
  for (std::size_t k = 0; k < first.records.size(); ++k) {
    const auto& a = first.records[k];
    const auto& b = second.records[k];
    REQUIRE(a.command.speed_m_s.left == b.command.speed_m_s.left);
    REQUIRE(a.command.speed_m_s.right == b.command.speed_m_s.right);
    REQUIRE(a.predicted.x_m == b.predicted.x_m);
    REQUIRE(a.odometry.theta_rad == b.odometry.theta_rad);
  }
}

TEST_CASE(
    "A calibration on a machine that is late now and then agrees with a punctual one, within its interval") {
  const auto gains = [](const std::function<std::chrono::nanoseconds(std::int64_t)>& lateness) {
    simulation::SimulatedRobot robot(test::robot_in_room("default", "box_without_slip", 1));
    auto config = calibration_only();
    config.host_lateness = lateness;
    return daemon::run_virtually(config, robot);
  };
  const auto punctual = gains({});
  const auto late =
      gains([](std::int64_t tick) { return std::chrono::milliseconds(tick % 37 == 5 ? 10 : 0); });
  REQUIRE(punctual.response);
  REQUIRE(late.response);
  CHECK(punctual.remarks.empty());
  CHECK_FALSE(late.remarks.empty());
  const auto& fit = late.response->left;
  CHECK_THAT(fit.gain.from_left,
             WithinAbs(punctual.response->left.gain.from_left, 3.0 * fit.gain_standard_error.from_left));
}

TEST_CASE("A calibration on a machine that is often late ends with a refusal, and the robot stands") {
  simulation::SimulatedRobot robot(test::robot_in_room("default", "box_without_slip", 1));
  auto config = calibration_only();
  config.host_lateness = [](std::int64_t tick) { return std::chrono::milliseconds(tick % 9 == 5 ? 10 : 0); };
  const auto result = daemon::run_virtually(config, robot);
  CHECK_FALSE(result.finished);
  REQUIRE(result.refusal);
  CHECK_THAT(result.refusal->reason, ContainsSubstring("the machine was too busy"));
  CHECK(robot.truth().wheels_at_rest);
}

TEST_CASE("A route that the new model cannot hold is refused after the calibration, and the model is kept") {
  simulation::SimulatedRobot robot(test::robot_in_room("default", "box", 1));
  daemon::VirtualRunConfig config = calibration_only();
  config.mission.route = Route{"there and back", 0.2, 0.02, {{1.0, 0.0}, {0.0, 0.0}}};
  config.mission.largest_uncertainty_m = 0.005;
  const auto result = daemon::run_virtually(config, robot);
  CHECK_FALSE(result.finished);
  CHECK(result.model);
  REQUIRE(result.refusal);
  CHECK_THAT(result.refusal->reason, ContainsSubstring("run.largest_uncertainty_m is 0.005"));
  CHECK(robot.truth().wheels_at_rest);
  CHECK(std::none_of(result.records.begin(), result.records.end(),
                     [](const PoseRecord& record) { return record.command.activity == Activity::route; }));
}
