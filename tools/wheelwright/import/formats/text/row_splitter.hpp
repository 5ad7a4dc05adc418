// How the rows of a table are parted into cells.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/formats/text/time_text.hpp"

namespace wheelwright::import {

struct Dialect {
  char separator = ',';           // ' ' for runs of blanks and tabulators, '\0' for one column
  char decimal = '.';             // or ','
  bool has_groups = false;        // of three digits each: "1,234" is more than a thousand
  bool rows_are_quoted = false;   // "10, 0.5, 3"
  bool rows_are_stamped = false;  // 12:34:56.789 -> 10,0.5,3; the stamp is the first cell
  DateOrder date_order = DateOrder::day_first;
};

inline constexpr std::size_t max_columns = 4096;

// The cells of a line without blanks and quotes around them; at most max_columns + 1 of them.
void split_row(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& cells);

// A cell whose quotes are doubled within, as it was meant.
std::string unescape_quotes(std::string_view cell);

// Whether a line is a comment: it begins with '#', '%' or "//".
bool is_comment(std::string_view line);
// What stands behind the sign of a comment.
std::string_view comment_text(std::string_view line);

}  // namespace wheelwright::import
