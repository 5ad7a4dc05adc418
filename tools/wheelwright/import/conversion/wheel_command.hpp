// What a command asks of each wheel.
#pragma once

#include "model/drive_log.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Left and right in m/s, of the two values of a command (left and right, or linear and angular). Of a duty
// without a full scale the share of it.
WheelPair wheel_command(const Mapping& mapping, double first, double second);

}  // namespace wheelwright::import
