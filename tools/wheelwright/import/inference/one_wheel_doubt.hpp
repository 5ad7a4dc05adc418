// Whether a log that was taken for one wheel may hold two.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// A line in `doubts` where one wheel was found by its motion alone, and another table has a column of the
// same name, or the same table two more that change: nobody stated that there is but one.
void doubt_one_wheel(std::span<const Recording> recordings, const GivenMapping& given, const Mapping& mapping,
                     std::vector<std::string>& doubts);

}  // namespace wheelwright::import
