// What a mapping lacks for a drive log.
#pragma once

#include <string>

#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// One line with the option that gives it; empty where nothing is missing.
std::string what_is_missing(const Mapping& mapping);

// Whether the log is of one wheel alone.
bool is_one_wheel(const Mapping& mapping);

}  // namespace wheelwright::import
