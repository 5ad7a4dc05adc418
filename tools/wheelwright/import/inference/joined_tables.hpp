// One table of several that have a clock each, so that columns without names can be compared.
#pragma once

#include <optional>
#include <span>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// The tables of a file of lines of several kinds whose columns have no names and whose first column is a
// clock, at the rows of the one of counts by its key, else of the longest: columns are called as a mapping
// names them ("ENC:2"), its own first the clock. Nothing where there are not two of them.
std::optional<Stream> joined_tables(std::span<const Recording> recordings);

}  // namespace wheelwright::import
