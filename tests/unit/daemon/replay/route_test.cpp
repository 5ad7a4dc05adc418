// Routes on the virtual clock.
#include <cmath>
#include <utility>

#include "daemon/replay/virtual_run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/simulated_run.hpp"

using namespace wheelwright;

namespace {

const Route triangle{"triangle", 0.15, 0.02, {{0.6, 0.0}, {0.6, 0.5}, {0.0, 0.0}}};

RobotModel calibrated_model(const std::string& robot_name) {
  simulation::SimulatedRobot robot(test::robot_in_room(robot_name, "box_without_slip", 1));
  daemon::VirtualRunConfig config;
  config.mission.encoder_turn = EncoderTurnPlan{};
  config.mission.response = ResponsePlan{};
  const auto result = daemon::run_virtually(config, robot);
  REQUIRE(result.finished);
  return *result.model;
}

daemon::VirtualRunResult drive(const RobotModel& model, PoseSource source, const std::string& robot_name,
                               std::uint64_t seed, const daemon::TickHook& hook = {}) {
  simulation::SimulatedRobot robot(test::robot_in_room(robot_name, "empty", seed));
  daemon::VirtualRunConfig config;
  config.mission.route = triangle;
  config.mission.pose_source = source;
  config.model = model;
  return daemon::run_virtually(config, robot, hook);
}

}  // namespace

TEST_CASE("A route from the model alone closes on a robot without imperfections") {
  const RobotModel model = calibrated_model("perfect");
  const auto result = drive(model, PoseSource::fir, "perfect", 3);
  REQUIRE(result.finished);
  CHECK(*true_closure_m(result) < 0.01);
  CHECK(result.records.back().visited == 3);
}

// A lag of 60 ms after a dead time of two periods: exactly as a recursion, and as the start of its impulse
// response.
RobotModel lagging(ModelType type) {
  const double keeps = std::exp(-0.018 / 0.06);
  RobotModel model;
  model.linear_part.type = type;
  const bool recursive = type == ModelType::arma;
  const std::size_t length = recursive ? 3 : 100;
  model.linear_part.left.from_left.assign(length, 0.0);
  model.linear_part.left.from_right.assign(length, 0.0);
  double weight = 1.0 - keeps;
  for (std::size_t i = 2; i < length; ++i, weight *= keeps) model.linear_part.left.from_left.at(i) = weight;
  if (recursive) model.linear_part.left.from_own_past = {keeps, 0.0};
  model.linear_part.right = model.linear_part.left;
  std::swap(model.linear_part.right.from_left, model.linear_part.right.from_right);
  return model;
}

TEST_CASE("A model of type arma gives the commands that its impulse response gives") {
  const auto recursive = drive(lagging(ModelType::arma), PoseSource::arma, "perfect", 3);
  const auto moving_average = drive(lagging(ModelType::fir), PoseSource::fir, "perfect", 3);
  REQUIRE(recursive.finished);
  REQUIRE(recursive.records.size() == moving_average.records.size());
  for (std::size_t k = 0; k < recursive.records.size(); ++k) {
    REQUIRE_THAT(recursive.records[k].command.speed_m_s.left,
                 WithinAbs(moving_average.records[k].command.speed_m_s.left, 0.0011));
  }
}

TEST_CASE("An encoder that freezes for a while leads odometry astray, and the hybrid pose not") {
  const RobotModel model = calibrated_model("default");
  const daemon::TickHook freeze = [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    using Kind = simulation::Fault::Kind;
    if (tick == 250) robot.inject({.kind = Kind::freeze_encoder, .side = simulation::Side::left});
    if (tick == 310) robot.inject({.kind = Kind::thaw_encoder, .side = simulation::Side::left});
  };
  const auto sound = drive(model, PoseSource::hybrid, "default", 3);
  const auto hybrid = drive(model, PoseSource::hybrid, "default", 3, freeze);
  const auto odometry = drive(model, PoseSource::odometry, "default", 3, freeze);
  REQUIRE(sound.finished);
  REQUIRE(hybrid.finished);
  REQUIRE(odometry.finished);
  CHECK(*true_closure_m(sound) < 0.05);
  CHECK(*true_closure_m(hybrid) < 0.05);
  CHECK(*true_closure_m(odometry) > 0.1);

  // Whatever steers, the fault is found.
  for (const auto* result : {&hybrid, &odometry}) {
    bool named = false;
    for (const PoseRecord& record : result->records) {
      if (!record.hybrid) continue;
      for (const FaultEvent& event : record.hybrid->events) {
        named = named || (event.kind == FaultKind::frozen && event.wheel == FaultyWheel::left);
      }
    }
    CHECK(named);
  }
}

TEST_CASE("A route by odometry closes too") {
  const RobotModel model = calibrated_model("perfect");
  const auto result = drive(model, PoseSource::odometry, "perfect", 3);
  REQUIRE(result.finished);
  CHECK(*true_closure_m(result) < 0.02);
}

TEST_CASE("Commands of a model-only route do not depend on any sensor") {
  const RobotModel model = calibrated_model("default");
  const auto commands_of = [](const daemon::VirtualRunResult& result) {
    std::vector<WheelPair> commands;
    for (const auto& record : result.records) {
      if (record.command.activity == Activity::route) commands.push_back(record.command.speed_m_s);
    }
    return commands;
  };
  // Another floor, another seed, and one run in which an encoder freezes on the way.
  const auto first = commands_of(drive(model, PoseSource::fir, "default", 3));
  const auto second = commands_of(drive(model, PoseSource::fir, "create2", 4));
  const auto third = commands_of(
      drive(model, PoseSource::fir, "default", 5, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
        if (tick == 300)
          robot.inject({.kind = simulation::Fault::Kind::freeze_encoder, .side = simulation::Side::left});
      }));
  REQUIRE(first.size() > 200);
  for (const auto& other : {second, third}) {
    REQUIRE(other.size() == first.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
      REQUIRE(first[k].left == other[k].left);
      REQUIRE(first[k].right == other[k].right);
    }
  }
}

TEST_CASE("A wheel that drops stops the run, and the wheels with it") {
  const RobotModel model = calibrated_model("default");
  const auto result =
      drive(model, PoseSource::fir, "default", 3, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
        if (tick == 300)
          robot.inject({.kind = simulation::Fault::Kind::lift_wheel, .side = simulation::Side::right});
      });
  CHECK_FALSE(result.finished);
  CHECK(result.stop == StopReason::wheel_drop);
  CHECK(result.records.back().command.speed_m_s.left == 0.0);
}
