// Mapping files: YAML, `wheelwright_mapping: 1`, read strictly.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// The mapping of keys and values; one that is not there has its default. A section of which the first channel
// is not said (command.left) is absent. Throws config::ConfigError, which names the option or the file that
// said what cannot be, or `name`, what was read, where it was found there.
Mapping to_mapping(const std::vector<MappingEntry>& entries, const std::string& name);

// Throws config::ConfigError, with file, line and column, for anything that a mapping file may not hold.
void check_mapping_file(const std::filesystem::path& file);

}  // namespace wheelwright::import
