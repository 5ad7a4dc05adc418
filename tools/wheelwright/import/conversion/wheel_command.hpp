// What a command asks of each wheel.
#pragma once

#include <array>
#include <span>

#include "model/log/drive_log.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Left and right in m/s, of the two values of a command (left and right, or linear and angular). Of a duty
// without a full scale the share of it.
WheelPair wheel_command(const Mapping& mapping, double first, double second);

// What is commanded to each wheel at each of the rows, until the next; not-a-number before the first command.
// Empty where that takes a wheel base that is not known.
std::array<Column, 2> wheel_commands(const DriveColumns& columns, std::span<const std::size_t> rows,
                                     const Mapping& mapping);

// Commands about zero, of commands about the number at which the wheels rest. A 0 that lies apart from all
// others, by more than half of `neutral`, is that of a receiver that heard no pulse, and rest.
void subtract_neutral(DriveColumns& columns, double neutral);

// Commands of a Create are a velocity and the radius of the turn: they become those of the left and the right
// wheel, in the same unit. In millimetres a radius of 32767 or 32768 is straight ahead, of 1 and -1 a turn on
// the spot, to the left and to the right. Numbers of 16 bits without a sign get it. Without a wheel base all
// go straight.
void turn_by_radius(DriveColumns& columns, const Mapping& mapping);

// A duty is negative where the bit beside it is not that of forward.
void apply_directions(DriveColumns& columns, double forward);

// The commands of wheels that a positive number drives backward.
void reverse_commands(DriveColumns& columns, const CommandMapping& command);

}  // namespace wheelwright::import
