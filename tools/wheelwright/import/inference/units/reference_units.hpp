// The units of a reference, by how far it goes and turns beside the counts; and the scale of the counts by
// it, where no one states it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// WheelMapping::scale_from.
inline constexpr auto from_commands = "commands";
inline constexpr auto from_reference = "reference";

// Metres per count, or the radius of wheels that tell their angle, by the places of the reference, and the
// unit of these; says so in `findings`. False, and nothing is set, without places, headings or such travel;
// or, if it has to agree, unless the turns of the reference about the given wheel base lead to the same
// scale.
bool set_scale_by_reference(const DriveColumns& columns, const GivenMapping& given,
                            const std::array<double, 2>& directions, bool has_to_agree, Mapping& mapping,
                            std::vector<std::string>& findings);

// Of a mapping with wheels and their base. `directions`: 1, or -1 of a wheel that counts backwards. Sets what
// is not given; adds a line with the evidence to `findings`.
void set_reference_units(const DriveColumns& columns, const GivenMapping& given,
                         const std::array<double, 2>& directions, Mapping& mapping,
                         std::vector<std::string>& findings);

}  // namespace wheelwright::import
