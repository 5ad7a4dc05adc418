// The mapping of columns whose names say nothing: which assignment of them to time, commands and wheels the
// motion of a robot explains best.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Fills in what `mapping` lacks of time, command, wheels and reference, from the columns of the longest
// table; adds a line with the evidence to `findings`.
void map_by_numbers(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings);

}  // namespace wheelwright::import
