// The ARMA calibration on the virtual clock: encoder scale, response, random drive, and a route by the
// result.
#include <algorithm>
#include <cmath>

#include "config/load/route_file.hpp"
#include "daemon/replay/virtual_run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/recorded_drive.hpp"

using namespace wheelwright;

namespace {

Route paper_loop() {
  return config::load_route(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/routes/paper_loop.yaml");
}

daemon::VirtualRunConfig calibration() {
  daemon::VirtualRunConfig config;
  config.mission.encoder_turn = EncoderTurnPlan{};
  config.mission.response = ResponsePlan{};
  config.mission.response->repetitions = 4;
  config.mission.random_drive = RandomDrivePlan{};
  config.mission.pose_source = PoseSource::arma;
  return config;
}

// How far the robot truly was from the middle of the circle at most, once it had come into it.
double largest_distance_m(const daemon::VirtualRunResult& result, const RandomDrivePlan& plan) {
  double largest = 0.0;
  bool was_inside = false;
  const Pose& start = result.true_poses.front();
  for (std::size_t k = 0; k < result.records.size(); ++k) {
    if (result.records[k].command.activity != Activity::random_drive) continue;
    const Pose seen = between(start, result.true_poses[k]);
    const double distance_m = std::hypot(seen.x_m - plan.ahead_m, seen.y_m);
    was_inside = was_inside || distance_m < plan.radius_m;
    if (was_inside) largest = std::max(largest, distance_m);
  }
  return largest;
}

RobotModel model_of(const std::string& robot_name) {
  simulation::SimulatedRobot robot(test::robot_in_room(robot_name, "box", 1));
  auto config = calibration();
  config.mission.random_drive.reset();
  const auto result = daemon::run_virtually(config, robot);
  REQUIRE(result.finished);
  return *result.model;
}

}  // namespace

// By the model alone, in a hall with nothing to run into; the offset is the true one.
daemon::VirtualRunResult drive_paper_loop(const RobotModel& model, const std::string& robot_name,
                                          std::uint64_t seed) {
  simulation::SimulatedRobot robot(test::robot_on_endless_floor(robot_name, seed));
  daemon::VirtualRunConfig config;
  config.mission.route = paper_loop();
  config.mission.pose_source = PoseSource::arma;
  config.model = model;
  return daemon::run_virtually(config, robot);
}

TEST_CASE("A calibration of type arma gives a model that drives the paper's loop, from commands alone") {
  // The paper's mean offset by its ARMA model is 0.258 m.
  for (const std::string robot_name : {"perfect", "default"}) {
    INFO(robot_name);
    simulation::SimulatedRobot robot(test::robot_in_room(robot_name, "box", 1));
    const auto calibrated = daemon::run_virtually(calibration(), robot);
    INFO(name_of(calibrated.stop) << (calibrated.refusal ? calibrated.refusal->reason : ""));
    REQUIRE(calibrated.finished);
    REQUIRE(calibrated.arma);
    CHECK(calibrated.model->linear_part.type == ModelType::arma);
    CHECK_THAT(calibrated.arma->left.quality.gain.from_left, WithinAbs(1.0, 0.02));

    const auto result = drive_paper_loop(*calibrated.model, robot_name, 2);
    REQUIRE(result.finished);
    const Pose& end = result.records.back().predicted;
    CHECK(std::hypot(end.x_m, end.y_m) < 0.02);
    CHECK(*true_closure_m(result) < 0.258);
  }
}

TEST_CASE("The random drive stays in its circle for many seeds, by the model and by odometry") {
  const RobotModel model = model_of("default");
  for (const bool has_model : {true, false}) {
    for (std::uint64_t seed = 1; seed <= (has_model ? 3U : 1U); ++seed) {
      simulation::SimulatedRobot robot(test::robot_in_room("default", "box", seed));
      daemon::VirtualRunConfig config;
      config.mission.random_drive = RandomDrivePlan{};
      config.mission.random_drive->seed = seed;
      if (has_model) config.model = model;
      const auto result = daemon::run_virtually(config, robot);
      INFO("seed " << seed << (has_model ? ", by the model" : ", by odometry"));
      REQUIRE(result.finished);
      CHECK(largest_distance_m(result, *config.mission.random_drive) <
            config.mission.random_drive->radius_m + 0.05);
    }
  }
}

TEST_CASE("With the same model and seed two robots are given the same random drive") {
  const RobotModel model = model_of("default");
  const auto commands_of = [&](const std::string& robot_name, std::uint64_t robot_seed) {
    simulation::SimulatedRobot robot(test::robot_in_room(robot_name, "empty", robot_seed));
    daemon::VirtualRunConfig config;
    config.mission.random_drive = RandomDrivePlan{};
    config.mission.random_drive->duration_s = 20.0;
    config.model = model;
    const auto result = daemon::run_virtually(config, robot);
    std::vector<WheelPair> commands;
    for (const auto& record : result.records) {
      if (record.command.activity == Activity::random_drive) commands.push_back(record.command.speed_m_s);
    }
    return commands;
  };
  const auto first = commands_of("default", 1);
  const auto second = commands_of("create2", 2);
  REQUIRE(first.size() > 1000);
  REQUIRE(first.size() == second.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    REQUIRE(first[k].left == second[k].left);
    REQUIRE(first[k].right == second[k].right);
  }
}

TEST_CASE("A bump or a cliff ends the random drive, and no model is made") {
  for (const auto& [room, reason] :
       {std::pair{"corner", StopReason::bump}, std::pair{"stairs", StopReason::cliff}}) {
    simulation::SimulatedRobot robot(test::robot_in_room("default", room, 1));
    daemon::VirtualRunConfig config;
    config.mission.random_drive = RandomDrivePlan{};
    // A circle that reaches beyond the wall or the edge.
    config.mission.random_drive->ahead_m = reason == StopReason::cliff ? 1.5 : -1.0;
    const auto result = daemon::run_virtually(config, robot);
    INFO(room);
    // Backwards over an edge no cliff sensor looks: there the wheel drop is the first to know.
    const bool over_an_edge = reason == StopReason::cliff && result.stop == StopReason::wheel_drop;
    CHECK((result.stop == reason || over_an_edge));
    CHECK_FALSE(result.finished);
    CHECK_FALSE(result.model);
    CHECK(robot.truth().wheels_at_rest);
  }
}
