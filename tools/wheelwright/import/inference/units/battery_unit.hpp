// Whether the numbers of a battery can be its voltage.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// A battery without a stated unit whose numbers go beyond 60 is in millivolts from 2500 to 60 000; others are
// percent or raw numbers of a converter, and are not used. A line in `findings`.
void check_battery(std::span<const Recording> recordings, Mapping& mapping,
                   std::vector<std::string>& findings);

}  // namespace wheelwright::import
