// The frame of a reference: headings that grow clockwise, a y axis that points right.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets `reference.heading` or `reference.y_axis` of a mapping with headings or places, unless one of them is
// given; true if it did, so that `columns` have to be gathered again.
//
// The sense of the headings is compared with that of the motion (whose direction turns as the heading does,
// or against it) and with that of the robot, which is that of its wheels or commands. Headings against both
// are clockwise, and so are headings without places that turn against the robot; headings with the robot, and
// against the motion, stand beside a y axis that points right, or x and y that are exchanged. Headings and
// motion against the robot may be either both, as in a frame whose z points down, or sides that are
// exchanged. It is the former where two others agree (the wheels with an angular command or a gyro), and
// where nothing says which of both the frame is (an image, a tracker whose y points up); else sides that no
// name tells (motors 1 and 2) are exchanged, and others are a line in `doubts`. Places to the north and east
// are in a known frame: against the robot they are a doubt.
bool infer_reference_frame(std::span<const Recording> recordings, const DriveColumns& columns,
                           const GivenMapping& given, Mapping& mapping, std::vector<std::string>& findings,
                           std::vector<std::string>& doubts);

}  // namespace wheelwright::import
