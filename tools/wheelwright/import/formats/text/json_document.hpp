// A whole file that is one JSON value: an array of objects or of arrays, each a row, or arrays of numbers,
// each a column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct JsonDocument {
  std::vector<Stream> streams;  // rows of the same members; columns of the same length
  std::vector<std::pair<std::string, std::string>> metadata;  // members that stand alone
};

// Nothing where the text is no JSON, or has no rows and no columns.
std::optional<JsonDocument> read_json_document(std::string_view text);

}  // namespace wheelwright::import
