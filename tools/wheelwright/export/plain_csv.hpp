// A run as one CSV that pandas and PlotJuggler open as it is.
#pragma once

#include <string>

#include "tools/wheelwright/export/recorded_run.hpp"

namespace wheelwright::tools {

// The header row first, no metadata; one row per tick; all columns of the drive log, then those of the pose
// log that the drive log does not have. SI units as in the logs.
std::string to_plain_csv(const RecordedRun& run);

}  // namespace wheelwright::tools
