// After what time without a command a robot stopped by itself, as its wheels show it.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Where commands that came all the time are missing (command_holes.hpp): sets `command.timeout_s`, with a
// line in `findings`, to the time that people choose (0.1 to 3 s) by which commands explain the wheels best,
// if that gains 50 in log-likelihood over commands that hold; puts the zeros into `columns`.
void infer_watchdog(DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings);

}  // namespace wheelwright::import
