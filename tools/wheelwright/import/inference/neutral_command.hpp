// The number at which the wheels rest, of commands that are never negative: the pulses of a remote control
// (about 1500 us), a pulse width about 128, the angle of a servo about 90.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Finds `command.neutral` by the motion unless it is given, and takes it off the commands of `columns`; adds
// a line with the evidence to `findings`.
//
// The speed is fitted by a response and a constant, and the neutral is where that line has no speed. It has
// to explain more than a response alone (50 nats), and the wheels have to agree: the command that they rest
// at is near it, or, where they never rest, commands go to both sides of it. So a dead zone of commands that
// begin at 0 is none. Of counters without a direction the command at which the wheels rest is taken if the
// commands about it explain the speed so much better.
void infer_neutral(DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings);

}  // namespace wheelwright::import
