// The daemon's logs as lines of text (columns: README.md).
#pragma once

#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

// Before the run starts there is nothing that belongs to it.
bool is_logged(const LogEntry& entry);

// Everything above the first row: metadata lines and the header row, each with its line end.
std::string drive_log_head(const config::DaemonConfig& config, const WheelPair& metres_per_tick);
std::string drive_log_line(const LogEntry& entry);

std::string pose_log_head(const config::DaemonConfig& config);
std::string pose_log_line(const LogEntry& entry, double wheel_base_m);

}  // namespace wheelwright::daemon
