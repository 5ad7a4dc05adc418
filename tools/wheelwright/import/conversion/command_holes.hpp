// Commands that came all the time, and then no more.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"

namespace wheelwright::import {

struct CommandHole {
  std::size_t row = 0;  // of the run, with the last command before the hole
  double duration_s = 0.0;
};

// Where commands that are written at a steady rate are missing for a second and for 20 of their steps, after
// one that was not 0: whether the robot went on, or its watchdog stopped it, the log does not say. Commands
// that are written where they change have no rate. `rows` and `t_s` are those of a run.
std::vector<CommandHole> command_holes(const DriveColumns& columns, const std::vector<std::size_t>& rows,
                                       const std::vector<double>& t_s);

}  // namespace wheelwright::import
