// What the daemon makes sure of before it starts: that its files can be written at the end.
#pragma once

#include "config/load/daemon_config.hpp"
#include "daemon/process.hpp"

namespace wheelwright::daemon {

// Throws ConfigError where the status or lateness file, or the model file of a calibration to come, may not
// be written. The status file in a service's runtime folder is not asked for by anybody, and is left out.
void check_daemon_outputs(const config::DaemonConfig& config, const ProcessOptions& options);

}  // namespace wheelwright::daemon
