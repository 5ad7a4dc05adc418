// The brain over the log of a run writes the run's own pose log again, to the byte.
#include <sstream>
#include <string>

#include "config/load/daemon_config.hpp"
#include "config/load/drive_log_file.hpp"
#include "daemon/recording/log_format.hpp"
#include "daemon/replay/replay.hpp"
#include "daemon/replay/virtual_run.hpp"
#include "daemon/wiring/plan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/outdated_model.hpp"
#include "tests/support/simulated_run.hpp"

using namespace wheelwright;

namespace {

config::DaemonConfig configuration(PoseSource source, bool calibrate) {
  auto config = config::load_daemon_config(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/wheelwright.yaml");
  config.calibrate = calibrate ? config::CalibrateWhen::always : config::CalibrateWhen::never;
  config.encoder_turn.turns_each_way = 1.8;
  config.response.repetitions = 3;
  config.pose_source = source;
  config.route = Route{"triangle", 0.15, 0.02, {{0.4, 0.0}, {0.4, 0.3}, {0.0, 0.0}}};
  return config;
}

daemon::VirtualRunResult drive(const config::DaemonConfig& config, const std::optional<RobotModel>& model,
                               std::uint64_t seed, const daemon::TickHook& hook = {}) {
  const auto plan = daemon::make_plan(config, model);
  daemon::VirtualRunConfig run;
  run.mission = plan.mission;
  run.limits = config.limits;
  run.link = config.link;
  run.model = plan.model;
  simulation::SimulatedRobot robot(test::robot_in_room("default", "box_without_slip", seed));
  return daemon::run_virtually(run, robot, hook);
}

const RobotModel& model() {
  static const RobotModel made = *drive(configuration(PoseSource::odometry, true), {}, 1).model;
  return made;
}

// The logs of a run as the daemon's log thread writes them, the drive log read back and replayed.
struct Replayed {
  std::string pose_log;
  daemon::ReplayResult again;
};

Replayed replayed(const daemon::VirtualRunResult& run, const config::DaemonConfig& config,
                  const std::optional<RobotModel>& start) {
  std::string drive_log = daemon::drive_log_head(config, config.limits.metres_per_tick);
  std::string pose_log = daemon::pose_log_head(config);
  for (std::size_t k = 0; k < run.records.size(); ++k) {
    const daemon::LogEntry entry{run.frames[k], run.records[k]};
    if (!daemon::is_logged(entry)) continue;
    drive_log += daemon::drive_log_line(entry) + "\n";
    pose_log += daemon::pose_log_line(entry, config.limits.wheel_base_m) + "\n";
  }
  return {pose_log, daemon::replay(config::parse_drive_logs(drive_log, "virtual").front(), config, start)};
}

// The line at which two texts part; empty where they do not.
std::string first_difference(const std::string& one, const std::string& other) {
  std::istringstream lines(one);
  std::istringstream others(other);
  std::string line;
  std::string other_line;
  while (true) {
    const bool has_line = static_cast<bool>(std::getline(lines, line));
    const bool has_other = static_cast<bool>(std::getline(others, other_line));
    if (!has_line && !has_other) return "";
    if (!has_line || !has_other || line != other_line) return line + "\n" + other_line;
  }
}

void check_the_same(const Replayed& result) {
  CHECK_FALSE(result.again.first_difference);
  INFO(first_difference(result.pose_log, result.again.pose_log));
  CHECK(first_difference(result.pose_log, result.again.pose_log).empty());
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("Replay of a drive in which an encoder jumps finds the same fault at the same tick") {
  const daemon::TickHook jump = [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    if (tick == 250) {
      robot.inject(
          {.kind = simulation::Fault::Kind::add_counts, .side = simulation::Side::right, .counts = 60});
    }
  };
  for (const auto source : {PoseSource::fir, PoseSource::hybrid, PoseSource::odometry}) {
    INFO(name_of(source));
    const auto config = configuration(source, false);
    const auto run = drive(config, model(), 4, jump);
    REQUIRE(run.finished);
    const auto result = replayed(run, config, model());
    CHECK(holds(result.pose_log, "named spike right"));
    check_the_same(result);
  }
}

TEST_CASE("Replay of given commands gives the same pose log, with a model and without") {
  auto config = configuration(PoseSource::fir, false);
  config.route.reset();
  config.commanded_drive =
      CommandedDrive{"both ways round", {{0.0, {0.1, -0.05}}, {1.5, {-0.05, 0.1}}, {3.0, {}}}, 3.5};
  for (const bool known : {true, false}) {
    INFO((known ? "with a model" : "without"));
    const auto start = known ? std::optional(model()) : std::nullopt;
    const auto run = drive(config, start, 6);
    INFO(name_of(run.stop));
    REQUIRE(run.finished);
    const auto driven = std::ranges::count_if(run.frames, [](const SensorFrame& frame) {
      return frame.command.activity == Activity::commanded_drive && frame.command.speed_m_s.left == 0.1;
    });
    CHECK(driven == 83);  // 1.5 s
    check_the_same(replayed(run, config, start));
  }
}

TEST_CASE("Replay of a run that calibrates and drives by the hybrid pose gives the same pose log") {
  const auto config = configuration(PoseSource::hybrid, true);
  const auto run = drive(config, {}, 2);
  REQUIRE(run.finished);
  check_the_same(replayed(run, config, {}));
}

TEST_CASE(
    "Replay of a run that calibrates by a random drive and drives by its model gives the same pose log") {
  auto config = configuration(PoseSource::arma, true);
  config.calibration_type = ModelType::arma;
  config.random_drive.duration_s = 20.0;
  config.random_drive.order = 3;
  const auto run = drive(config, {}, 2);
  INFO(name_of(run.stop) << (run.refusal ? run.refusal->reason : ""));
  REQUIRE(run.arma);
  check_the_same(replayed(run, config, {}));
}

TEST_CASE("Replay of a run that a wheel drop ended gives the same pose log") {
  const auto config = configuration(PoseSource::hybrid, false);
  const auto run = drive(config, model(), 5, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    if (tick == 250)
      robot.inject({.kind = simulation::Fault::Kind::lift_wheel, .side = simulation::Side::right});
  });
  REQUIRE(run.stop == StopReason::wheel_drop);
  const auto result = replayed(run, config, model());
  CHECK(holds(result.pose_log, "named lifted wheel both"));
  check_the_same(result);
}

TEST_CASE("A route by odometry ends where an encoder counts no more, and its replay likewise") {
  const auto config = configuration(PoseSource::odometry, false);
  const auto run = drive(config, model(), 5, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    if (tick == 250)
      robot.inject({.kind = simulation::Fault::Kind::freeze_encoder, .side = simulation::Side::left});
  });
  REQUIRE(run.stop == StopReason::lost_count);
  CHECK(run.records.back().tick < 250 + 200);
  check_the_same(replayed(run, config, model()));
}

TEST_CASE("A route ends where a wheel is held and does not come free") {
  auto config = configuration(PoseSource::fir, false);
  config.route->checkpoints = test::laps(3);
  const auto run = drive(config, model(), 5, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    if (tick == 300)
      robot.inject({.kind = simulation::Fault::Kind::stall_wheel, .side = simulation::Side::left});
  });
  CHECK((run.stop == StopReason::held || run.stop == StopReason::overcurrent));
  CHECK(run.records.back().tick < 300 + 200);
}

TEST_CASE("Replay of a stop on a route by the model alone takes back what was predicted ahead as well") {
  const auto config = configuration(PoseSource::fir, false);
  const auto run = drive(config, model(), 5, [](simulation::SimulatedRobot& robot, std::int64_t tick) {
    if (tick == 250)
      robot.inject({.kind = simulation::Fault::Kind::lift_wheel, .side = simulation::Side::right});
  });
  REQUIRE(run.stop == StopReason::wheel_drop);
  check_the_same(replayed(run, config, model()));
}

TEST_CASE("Replay of a drive in which a better model took over applies it at the same tick") {
  for (const auto source : {PoseSource::fir, PoseSource::hybrid}) {
    INFO(name_of(source));
    auto config = configuration(source, false);
    config.route->checkpoints = test::laps(8);
    const RobotModel start = test::scaled(model(), 0.93);
    const auto run = drive(config, start, 6);
    REQUIRE(run.adapted.size() == 1);
    REQUIRE(run.records.back().model_version == 2);
    check_the_same(replayed(run, config, start));
  }
}

TEST_CASE("A log whose exchange of models cannot be repeated is said to differ from that tick on") {
  auto config = configuration(PoseSource::fir, false);
  config.route->checkpoints = test::laps(8);
  const RobotModel start = test::scaled(model(), 0.93);
  const auto run = drive(config, start, 6);
  REQUIRE(run.adapted.size() == 1);
  std::int64_t exchanged = 0;
  for (const PoseRecord& record : run.records) {
    if (record.model_version == 1) exchanged = record.tick + 1;
  }
  config.adapt = false;
  CHECK(replayed(run, config, start).again.first_difference == exchanged);
}
