// What a person says of a recording.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// What a person says of a recording, key by key: a mapping file, or single keys ("time.unit=ms"), or both, of
// which the keys hold. What is not said is left to be found.
class GivenMapping {
 public:
  GivenMapping() = default;
  // Throws config::ConfigError, with file, line and column, for anything that a mapping file may not hold,
  // and for a setting that is not KEY=VALUE.
  GivenMapping(const std::filesystem::path& file, const std::vector<std::string>& settings);

  // The same, and a key that was found.
  GivenMapping with(std::string_view key, const std::string& value) const;

  const std::vector<MappingEntry>& entries() const { return entries_; }
  // The value of a key such as "time.unit", or nothing.
  const std::string* find(std::string_view key) const;
  bool says(std::string_view key) const { return find(key) != nullptr; }

 private:
  std::vector<MappingEntry> entries_;
};

}  // namespace wheelwright::import
