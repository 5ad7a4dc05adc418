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

// In the runtime folder of the service, from before the port is opened until the robot was left at rest.
inline constexpr auto rest_target_file_name = "rest.yaml";

// The daemon ends, and has left the robot at rest.
void note_farewell(const std::filesystem::path& runtime_folder);
// Whether a daemon has ended, or runs, that has not. False where the folder is not known.
bool lacks_farewell(const std::filesystem::path& runtime_folder);

// Where the robot may be, most likely first: as the daemon that ran kept it in `runtime_folder` (empty: there
// is none), as the configuration says as far as it can be read, at /dev/roomba with 115200 baud. A `device`
// that is given replaces those of all.
std::vector<config::RestTarget> rest_targets(const std::filesystem::path& runtime_folder,
                                             const std::filesystem::path& config_file,
                                             const std::filesystem::path& device);

// Orders the robot on the first device that can be opened to stand and, once it does, to leave its driving
// mode. False where none of the devices is there: then there is no way to the robot. Throws StartFailure
// where there is one, but none can be opened.
bool rest_wheels(const std::vector<config::RestTarget>& targets);

// The same, as the service's ExecStopPost=, which knows from $EXIT_CODE and $EXIT_STATUS how the daemon
// ended: where it ended by itself and left the robot at rest, in Off mode, nothing is done. Not so after an
// internal fault (status 70), which may be a sensor loop that hangs (the guardian was to stop the wheels, and
// may be gone), and where the robot could not be reached at the end (status 76, or any with a farewell
// missing).
bool rest_after_end(const std::filesystem::path& runtime_folder,
                    const std::vector<config::RestTarget>& targets);

}  // namespace wheelwright::daemon
