// What a table holds beside the columns that are taken for something.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Whether a channel of a stream is one that the mapping names.
bool is_used(const Mapping& mapping, const Stream& stream, const Channel& channel);

// "not used: column 6 and column 7": those of the table with the wheels or commands that change, but for
// numbers of the rows. Nothing where all are used, and for recordings of messages.
std::optional<std::string> unused_columns(std::span<const Recording> recordings, const Mapping& mapping);

}  // namespace wheelwright::import
