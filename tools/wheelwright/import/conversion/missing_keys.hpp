// What a mapping lacks for a drive log.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

struct MissingKey {
  std::string what;     // "the distance between the wheels"; of columns "commands"
  std::string example;  // "robot.wheel_base_m=0.235"; several with blanks between them
  bool is_column = false;
};

// All that is missing; empty where a drive log can be made.
std::vector<MissingKey> missing_keys(const Mapping& mapping);

// The same as one line with one example of the options that give it; empty where nothing is missing.
std::string what_is_missing(const Mapping& mapping);

// Whether the log is of one wheel alone.
bool is_one_wheel(const Mapping& mapping);

}  // namespace wheelwright::import
