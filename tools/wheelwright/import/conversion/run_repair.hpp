// The runs that the rows of mapped columns make.
#pragma once

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"

namespace wheelwright::import {

// Time made to rise (time_repair.hpp) within each run that the files tell apart; a new run begins where a
// counter of the wheels was set to zero.
TimeRepair repair_runs(const DriveColumns& columns, const Mapping& mapping);

}  // namespace wheelwright::import
