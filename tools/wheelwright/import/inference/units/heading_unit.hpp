// The unit of the headings of a log without wheels: by the turns of its commands.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Degrees where headings that nobody gives a unit turn some 57 times as far as commanded. Returns whether
// anything was changed.
bool infer_heading_unit(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings);

}  // namespace wheelwright::import
