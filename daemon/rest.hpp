// wheelwrightd --rest: puts the wheels of a robot to rest whose daemon is gone.
#pragma once

#include "config/load/daemon_config.hpp"

namespace wheelwright::daemon {

// Orders the robot on config.device to stand and, once it does, to leave its driving mode. Returns without a
// word where there is no such device: then there is no way to the robot. Throws StartFailure where the device
// cannot be opened for another reason.
//
// As the service's ExecStopPost= it is told by $EXIT_CODE that the daemon ended by itself, which is always in
// order; then the robot is in Off mode, and is left there.
void rest_wheels(const config::DaemonConfig& config);

}  // namespace wheelwright::daemon
