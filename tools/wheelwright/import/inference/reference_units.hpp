// The units of a reference, by how far it goes and turns beside the counts; and the scale of the counts by
// it, where it was found from the commands.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Of a mapping with wheels and their base. Sets what is not given; adds a line with the evidence to
// `findings`.
void set_reference_units(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings);

}  // namespace wheelwright::import
