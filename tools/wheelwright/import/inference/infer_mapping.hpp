// Finds out what the channels of a recording mean: by their names and types, by the units that the file
// states, and, where those say nothing, by which assignment the motion of a robot explains best.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct Inference {
  std::vector<MappingEntry> entries;  // a whole mapping: what was given, and what was found
  std::vector<std::string> findings;  // what was found and by what evidence, one line each
  std::vector<std::string> doubts;    // what the data say against what the file says, one line each
};

// What is given stands, whatever the data say. Throws config::ConfigError where what is given contradicts
// itself.
Inference infer_mapping(std::span<const Recording> recordings, const GivenMapping& given);

}  // namespace wheelwright::import
