// wheelwrightd --rest: puts the wheels of a robot to rest whose daemon is gone.
//
// It is the last line of defence (ExecStopPost= of the unit), so it needs nothing of the configuration but
// how to reach the robot, and looks for that in several places.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/load/rest_target.hpp"

namespace wheelwright::daemon {

inline constexpr auto rest_target_file_name = "rest.yaml";  // in the runtime folder of the service

// Where the robot may be, most likely first: as the daemon that ran kept it in `runtime_folder` (empty: there
// is none), as the configuration says as far as it can be read, at /dev/roomba with 115200 baud. A `device`
// that is given replaces those of all.
std::vector<config::RestTarget> rest_targets(const std::filesystem::path& runtime_folder,
                                             const std::filesystem::path& config_file,
                                             const std::filesystem::path& device);

// Orders the robot on the first device that can be opened to stand and, once it does, to leave its driving
// mode. False where none of the devices is there: then there is no way to the robot. Throws StartFailure
// where there is one, but none can be opened.
//
// As the service's ExecStopPost= it knows from $EXIT_CODE and $EXIT_STATUS that the daemon ended by itself
// and in order; then the robot is in Off mode, and is left there. Not so after an internal fault (status 70),
// which may be a sensor loop that hangs: the guardian was to stop the wheels, and may be gone.
bool rest_wheels(const std::vector<config::RestTarget>& targets);

}  // namespace wheelwright::daemon
