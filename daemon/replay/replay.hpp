// The daemon's brain over a recorded drive log: the same frames, the same commands, the same pose log.
#pragma once

#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

struct ReplayResult {
  std::string pose_log;  // whole, as the daemon would have written it
  std::size_t ticks = 0;
  // The first tick at which the brain commands something else than was recorded, where there is one: then the
  // log is not of this configuration and model, or not of this version of the brain.
  std::optional<std::int64_t> first_difference;
};

// `log` is a drive log of the daemon with all its columns; `model` is what the run started with. Throws
// config::ConfigError where a column is missing.
ReplayResult replay(const DriveLog& log, const config::DaemonConfig& config,
                    const std::optional<RobotModel>& model);

}  // namespace wheelwright::daemon
