// What a person states and nothing uses.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// A line in `doubts` where a wheel radius is given and no unit of wheels or commands is one of a turning
// wheel.
void doubt_idle_settings(const GivenMapping& given, const Mapping& mapping, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
