// The mapping that the names and types of channels suggest.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording.hpp"

namespace wheelwright::import {

// Fills in what `mapping` lacks, and adds a line to `findings` where one of several was taken.
void map_by_names(std::span<const Recording> recordings, Mapping& mapping,
                  std::vector<std::string>& findings);

}  // namespace wheelwright::import
