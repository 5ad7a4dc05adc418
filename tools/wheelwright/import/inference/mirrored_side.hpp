// A motor that is mounted the other way round: to drive forward its command is negative, and so are its
// counts. The two agree with each other, and only the places of the robot show it.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Reverses command and counts of one side where the robot then goes as far as its reference says, and as they
// stand does not; a line in `findings`. Signs that are given stay. Whether the mapping is another one then.
bool infer_mirrored_side(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings);

}  // namespace wheelwright::import
