// How a running daemon is: one JSON object in a file that is written again every second, and one line of it
// for the service manager. `wheelwright status` shows it.
//
// A file and not a socket: nothing listens, nobody can hold the daemon up, and the last state of a daemon
// that was killed is still there.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/threads/real_time_setup.hpp"
#include "daemon/wiring/wiring.hpp"
#include "drivers/roomba/sensor_loop.hpp"

namespace wheelwright::daemon {

// All that is told of one moment.
struct StatusView {
  const config::DaemonConfig& config;
  const roomba::SensorLoop& sensor_loop;
  const RealTimeStatus& real_time;
  std::filesystem::path run_folder;
  std::optional<LogEntry> latest;
  bool robot_answers = false;
  std::string watch{};  // what the watch over the model said at last
};

// What the robot does, in words: "waiting for the robot", "standing", "route", ..., "stopped: bump".
std::string phase_of(const StatusView& view);

// For people: phase, pose, battery, how late the loop was at worst.
std::string status_line(const StatusView& view);

// Keys: wheelwright_status (version of the form, 1), time, pid, robot, device, phase, stop, armed,
// model_version, pose {x_m, y_m, theta_rad, by}, battery_v, run_folder, and loop {system, period_s, ticks,
// overruns, skipped_periods, commands_late, replies_asked, replies_sound, lateness_us {p50, p99, p999,
// largest, histogram
// [[upper edge, wake-ups], ...]}}, watch (what the watch over the model said at last). What is not known is
// null.
std::string status_json(const StatusView& view);

// Removes a status file that this process wrote, and nothing else.
void remove_own_status(const std::filesystem::path& file);

}  // namespace wheelwright::daemon
