// Reads all rows of a text with one or more tables.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/text/dialect_sniffer.hpp"
#include "tools/wheelwright/import/formats/text/table_layout.hpp"
#include "tools/wheelwright/import/formats/text/text_table.hpp"

namespace wheelwright::import {

struct TextTables {
  std::vector<TextTable> tables;
  std::vector<std::pair<std::string, std::string>> metadata;  // of comments between the rows
  std::vector<std::string> remarks;
};

// A table begins where a new header row stands with rows beneath it, or where several rows follow one another
// that are wider or narrower than before. Lines that are no rows are left out with a remark. Refuses a text
// with more cells than memory is to be spent on, in one line without the name of the file.
tl::expected<TextTables, std::string> read_tables(std::string_view text, const Dialect& dialect,
                                                  const TableLayout& layout, std::size_t bytes_of_a_row);

}  // namespace wheelwright::import
