// Robots that stop by themselves where no command comes: the watchdog of most drivers of ROS bases.
#pragma once

#include "tools/wheelwright/import/conversion/drive_columns.hpp"

namespace wheelwright::import {

// Commands of 0 at the first row that is later than `timeout_s` after a command, where no other came since.
// Rows without a command hold the one before them.
void stop_after_timeout(DriveColumns& columns, double timeout_s);

}  // namespace wheelwright::import
