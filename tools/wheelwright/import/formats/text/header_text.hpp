// The words above a table: names in a comment, units in a row of their own, "key: value".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/text/row_splitter.hpp"

namespace wheelwright::import {

// The names in a comment above the rows ("#time;posL", "# Time [s]    x [m]"), parted by the separator of the
// rows or another; empty where they are not `width` names.
std::vector<std::string> comment_header(std::string_view comment, const Dialect& dialect, std::size_t width);

// "period_s: 0.05" or "period_s=0.05".
std::optional<std::pair<std::string, std::string>> key_and_value(std::string_view text);

// Whether most cells are units, in brackets or not, and the rest empty or '-'.
bool is_units_row(const std::vector<std::string>& cells);
// "m/s" of "[m/s]"; empty for '-'.
std::string bare_unit(std::string_view cell);

// Where names occur more than once and the row above has other ones over them ("left,left,right,right" over
// "pos,vel,pos,vel"), the two are joined: "left.pos". False where that is not so.
bool join_upper_names(const std::vector<std::string>& upper, std::vector<std::string>& names);

}  // namespace wheelwright::import
