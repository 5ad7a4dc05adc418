// The mapping that the names and types of channels suggest.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Fills in what `mapping` lacks, and adds a line to `findings` where one of several was taken.
void map_by_names(std::span<const Recording> recordings, Mapping& mapping,
                  std::vector<std::string>& findings);

// Of wheels whose columns a person states, but not their kind, by the names of these; `mapping` as given.
void set_kind_of_stated_wheels(std::span<const Recording> recordings, const GivenMapping& given,
                               Mapping& mapping);

}  // namespace wheelwright::import
