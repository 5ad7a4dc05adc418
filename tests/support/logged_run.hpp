// A run of the simulated robot on the virtual clock, with the folder that the daemon would leave of it.
#pragma once

#include <filesystem>
#include <fstream>

#include "config/load/daemon_config.hpp"
#include "daemon/recording/log_format.hpp"
#include "daemon/replay/virtual_run.hpp"
#include "daemon/wiring/plan.hpp"
#include "tests/support/simulated_run.hpp"

namespace wheelwright::test {

// The shipped configuration, made short: little turning, few response actions, a route of three points.
inline config::DaemonConfig short_configuration() {
  auto config = config::load_daemon_config(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/wheelwright.yaml");
  config.encoder_turn.turns_each_way = 1.8;
  config.response.repetitions = 3;
  config.route = Route{"triangle", 0.15, 0.02, {{0.4, 0.0}, {0.4, 0.3}, {0.0, 0.0}}};
  return config;
}

// Calibrates and drives, with the robot's seed given.
inline daemon::VirtualRunResult run_of(const config::DaemonConfig& config, std::uint64_t seed) {
  const auto plan = daemon::make_plan(config, std::nullopt);
  daemon::VirtualRunConfig run;
  run.mission = plan.mission;
  run.limits = config.limits;
  run.link = config.link;
  simulation::SimulatedRobot robot(robot_in_room("default", "box_without_slip", seed));
  return daemon::run_virtually(run, robot);
}

// Calls `take` with each entry of the logs.
template <typename Take>
void for_each_entry(const daemon::VirtualRunResult& run, Take take) {
  for (std::size_t k = 0; k < run.records.size(); ++k) {
    const daemon::LogEntry entry{run.frames[k], run.records[k]};
    if (daemon::is_logged(entry)) take(entry);
  }
}

// Writes config.yaml, drive_log.csv and pose_log.csv.
inline void write_logs(const daemon::VirtualRunResult& run, const config::DaemonConfig& config,
                       const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "config.yaml") << config::daemon_config_to_yaml(config);
  std::ofstream drive_log(folder / "drive_log.csv");
  std::ofstream pose_log(folder / "pose_log.csv");
  drive_log << daemon::drive_log_head(config, config.limits.metres_per_tick);
  pose_log << daemon::pose_log_head(config);
  for_each_entry(run, [&](const daemon::LogEntry& entry) {
    drive_log << daemon::drive_log_line(entry) << "\n";
    pose_log << daemon::pose_log_line(entry, config.limits.wheel_base_m) << "\n";
  });
}

}  // namespace wheelwright::test
