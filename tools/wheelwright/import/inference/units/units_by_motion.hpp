// Units and scales that a file does not state, from the motion itself: a robot that is asked for a speed
// comes near it, so that the steady gain from command to wheel tells millimetres from metres, and a duty from
// a speed.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets what is not given; adds a line with the evidence to `findings`, and to `doubts` where what is known
// cannot be.
void set_units(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
               std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
