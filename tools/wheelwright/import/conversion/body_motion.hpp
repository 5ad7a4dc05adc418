// The motion of the body, forward and turning, as that of the two wheels that lead to it:
// left = forward - b / 2 * turning, right = forward + b / 2 * turning.
#pragma once

#include <span>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

// The units that the turning motion may be in.
std::span<const Unit> turning_units(const WheelMapping& wheels);

// Puts left and right, in the unit of the forward motion, in place of forward and turning, where the wheels
// of the mapping are a motion of the body. Where the wheel base is not known both wheels go forward only.
void body_motion_to_wheels(DriveColumns& columns, const Mapping& mapping);

}  // namespace wheelwright::import
