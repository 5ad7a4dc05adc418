// What a tick, a wake-up and a message of the daemon look like on their channels.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "config/load/daemon_config.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon::telemetry {

// The frame that all poses are in: x forward and y left at the start of the route.
constexpr std::string_view route_frame = "route";
constexpr std::string_view robot_frame = "base_link";

// The pose that the robot steers by: that of the configured source, or odometry as long as there is no model.
const Pose& steering_pose(const PoseRecord& record, PoseSource source);

std::string pose_message(std::uint64_t time_ns, const Pose& pose);
std::string transform_message(std::uint64_t time_ns, const Pose& pose);
std::string wheels_message(std::uint64_t time_ns, const LogEntry& entry);
std::string light_bumper_message(std::uint64_t time_ns, const SensorFrame& frame);
std::string loop_message(std::uint64_t time_ns, double lateness_s);

// What no tick knows.
struct StepContext {
  bool robot_answers = false;
  std::uint64_t dropped = 0;  // ticks that the live view has lost
  std::size_t watchers = 0;
  std::string result;   // how the run came out, once it has
  std::string outcome;  // of one that has finished, its figures in words
};
std::string state_message(std::uint64_t time_ns, const LogEntry& entry, const config::DaemonConfig& config,
                          const StepContext& step_context);

enum class LogLevel : int { debug = 1, info = 2, warning = 3, error = 4, fatal = 5 };
std::string log_message(std::uint64_t time_ns, LogLevel level, std::string_view text);

}  // namespace wheelwright::daemon::telemetry
