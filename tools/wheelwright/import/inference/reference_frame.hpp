// The frame of a reference: headings that grow clockwise, a y axis that points right.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets `reference.heading` or `reference.y_axis` of a mapping with headings and both wheels, unless one of
// them is given; true if it did, so that `columns` have to be gathered again.
//
// The sense of the headings is compared with that of the motion (whose direction turns as the heading does,
// or against it) and with that of the wheels. Headings against both are clockwise, and so are
// headings without places that turn against the wheels; headings with the wheels, and against the motion,
// stand beside a y axis that points right, or x and y that are exchanged. Headings and motion against the
// wheels may be either both, as in a frame whose z points down, or sides that are exchanged: a line in
// `doubts`.
bool infer_reference_frame(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                           std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
