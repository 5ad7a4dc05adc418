// Counts since the row before, which look like a speed.
#pragma once

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Whether whole numbers of wheel speeds without a unit are counts since the row before: where the distance of
// a count is known, and they then come near the commands. `gain` is what the wheels show for 1 m/s.
bool are_counts_of_a_row(const DriveColumns& columns, double gain, const WheelMapping& wheels);

void take_counts_of_a_row(WheelMapping& wheels);

}  // namespace wheelwright::import
