// Units that a file states and that are not known here.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// A line in `doubts` for each mapped column, but for counts, whose stated unit no table has: it is taken for
// another, and nobody would see that.
void doubt_unknown_units(std::span<const Recording> recordings, const Mapping& mapping,
                         std::vector<std::string>& doubts);

}  // namespace wheelwright::import
