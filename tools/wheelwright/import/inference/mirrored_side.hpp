// A motor that is mounted the other way round: to drive forward its command is negative, and so are its
// counts. The two agree with each other, and only the places or headings of the robot show it.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Reverses command and counts of one side where the robot then goes as far as its reference says, or turns as
// far where that has headings alone, or there is but a gyro, and as they stand does not; a line in
// `findings`. Headings alone that grow clockwise would show the other side. Signs that are given stay.
// Whether the mapping is another one.
bool infer_mirrored_side(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings);

// Without a reference: a line in `doubts` where the wheels go opposite ways most of the time.
void doubt_mirrored_side(const DriveColumns& columns, const Mapping& mapping,
                         std::vector<std::string>& doubts);

}  // namespace wheelwright::import
