// Counts that were not read: a fault on the bus leaves 0, -1 or the largest number of the register in a row,
// and the counter goes on behind it where it was.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// The rows of such numbers. A stretch of one of them, of up to twenty rows, begins by a jump of ten large
// steps and ends by another one, to within two large steps for each row of where the counter was. A counter
// that wraps and comes near its ends does not jump there. A reset goes on from zero.
std::vector<std::size_t> misread_counts(std::span<const double> counts);

// Leaves them out of the wheels of columns, and says so in their remarks.
void leave_out_misread_counts(DriveColumns& columns, const WheelMapping& wheels);

}  // namespace wheelwright::import
