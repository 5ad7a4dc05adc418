// The same configuration gives the same bytes.
#include <map>

#include "config/load/daemon_config.hpp"
#include "config/load/model_file.hpp"
#include "config/load/simulation_config.hpp"
#include "daemon/replay/virtual_run.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::bench;

namespace {

// The commands of a route as the log has them, by tick since its start.
using Commands = std::map<std::int64_t, std::string>;

Commands route_commands(const Table& log) {
  Commands commands;
  std::int64_t first_tick = -1;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.word(row, "activity") != "route") continue;
    const auto tick = std::stoll(log.word(row, "tick"));
    if (first_tick < 0) first_tick = tick;
    commands[tick - first_tick] = log.word(row, "cmd_left") + "," + log.word(row, "cmd_right");
  }
  return commands;
}

// One drive on the wall clock, on a robot of its own.
Commands drive(const std::string& shipped_robot, const std::string& seed) {
  Bench bench;
  const auto robot = bench.start_robot(shipped_robot, "", {"--seed", seed});
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0.15, 0], [0.3, 0.06]]"}));
  CHECK(daemon->wait(20s) == 0);
  return route_commands(bench.drive_log());
}

// A tick that a busy machine has let pass is in one log and not in the other; those in both are the same.
void check_same(const Commands& one, const Commands& other) {
  CHECK(one.rbegin()->first == other.rbegin()->first);
  std::size_t shared = 0;
  for (const auto& [tick, command] : one) {
    const auto found = other.find(tick);
    if (found == other.end()) continue;
    ++shared;
    CAPTURE(tick);
    CHECK(found->second == command);
  }
  CHECK(20 * shared > 19 * one.size());
}

// One whole run on the virtual clock: calibrations and a route.
daemon::VirtualRunResult run_in_virtual_time(std::uint64_t seed) {
  const std::filesystem::path folder = std::string(WHEELWRIGHT_SOURCE_DIR) + "/config";
  const auto daemon_config = config::load_daemon_config(folder / "wheelwright.yaml");
  auto robot_config = config::load_simulation_config(folder / "robots/default.yaml");
  robot_config.seed = seed;
  daemon::VirtualRunConfig run;
  run.limits = daemon_config.limits;
  run.link = daemon_config.link;
  run.mission.encoder_turn = daemon_config.encoder_turn;
  run.mission.response = daemon_config.response;
  run.mission.response->repetitions = 3;
  run.mission.route = daemon_config.route;
  simulation::SimulatedRobot robot(robot_config);
  return daemon::run_virtually(run, robot);
}

bool same(const Pose& a, const Pose& b) {
  return a.x_m == b.x_m && a.y_m == b.y_m && a.theta_rad == b.theta_rad;
}

bool same(const WheelPair& a, const WheelPair& b) {
  return a.left == b.left && a.right == b.right;
}

bool same(const PoseRecord& a, const PoseRecord& b) {
  return a.tick == b.tick && a.t_s == b.t_s && a.command.activity == b.command.activity &&
         same(a.command.speed_m_s, b.command.speed_m_s) && a.stop == b.stop &&
         a.has_prediction == b.has_prediction && same(a.predicted, b.predicted) &&
         same(a.predicted_speed_m_s, b.predicted_speed_m_s) && same(a.odometry, b.odometry) &&
         same(a.measured_speed_m_s, b.measured_speed_m_s) && a.visited == b.visited && a.valid == b.valid;
}

}  // namespace

TEST_CASE("By the model alone, two robots that differ in seed and firmware get the same commands") {
  const auto first = drive("default", "1");
  REQUIRE(first.size() > 100);
  check_same(first, drive("create2", "3"));
}

TEST_CASE("In virtual time the same seed gives the same run to the last bit, calibrations included") {
  const auto first = run_in_virtual_time(7);
  const auto second = run_in_virtual_time(7);
  CHECK(first.finished);
  REQUIRE(first.records.size() == second.records.size());
  for (std::size_t i = 0; i < first.records.size(); ++i) {
    if (same(first.records[i], second.records[i]) && same(first.true_poses[i], second.true_poses[i]))
      continue;
    FAIL("tick " << i << " differs");
  }
  REQUIRE(first.response);
  REQUIRE(second.response);
  CHECK(first.response->model.left.from_left == second.response->model.left.from_left);
  CHECK(first.encoder_scale->ticks_per_turn == second.encoder_scale->ticks_per_turn);

  const auto other = run_in_virtual_time(8);
  REQUIRE(other.encoder_scale);
  CHECK(other.encoder_scale->ticks_per_turn != first.encoder_scale->ticks_per_turn);
}
