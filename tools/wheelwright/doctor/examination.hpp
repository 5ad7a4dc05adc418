// The examination as a whole: from the port to the kernel, in the order in which faults hide each other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "tools/wheelwright/doctor/finding.hpp"

namespace wheelwright::tools::doctor {

// Told what is going on now.
using Progress = std::function<void(const std::string& what)>;

// Takes 6 to 13 s. Moves the robot only where `move` is set, and leaves it at rest in Passive mode. Throws
// UsageError where the device cannot be opened, DataRefusal where the line goes dead meanwhile, Interrupted.
std::vector<Finding> examine(const config::DaemonConfig& config, bool move, const Progress& progress);

}  // namespace wheelwright::tools::doctor
