// The head of a table: where its rows begin, what its columns are called, and what stands in them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/text/dialect_sniffer.hpp"
#include "tools/wheelwright/import/formats/text/text_sample.hpp"

namespace wheelwright::import {

enum class ColumnKind { number, clock, date, date_and_time, text };

struct Column {
  std::string name;
  std::string unit;
  ColumnKind kind = ColumnKind::number;
};

struct TableLayout {
  std::vector<Column> columns;
  std::vector<std::string> header;  // cells of the header row as they stand there; empty without one
  bool header_is_comment = false;   // "#time;posL"
  bool has_units_row = false;       // beneath the header
  std::size_t first_row_line = 1;   // number of the line of the first row
  std::vector<std::pair<std::string, std::string>> metadata;
  std::vector<std::string> remarks;
};

// Nothing is refused here: a table without rows has first_row_line 0.
TableLayout find_layout(const TextSample& sample, const SniffedTable& table);

// The same for the further tables of a file, from their first lines.
std::vector<ColumnKind> column_kinds(const std::vector<std::string_view>& lines, const Dialect& dialect,
                                     std::size_t width);

// Names from a header row, without the units in their brackets, each name once, "3" for a third column
// without a name.
std::vector<Column> name_columns(const std::vector<std::string>& header, const std::vector<ColumnKind>& kinds,
                                 std::vector<std::string>& remarks);

// Whether a row can be a header: no cell is a number or a time, and not all are empty.
bool is_header_row(const std::vector<std::string_view>& cells, const Dialect& dialect);
// Whether a row has something to read in a column that is no text.
bool is_data_row(const std::vector<std::string_view>& cells, const std::vector<ColumnKind>& kinds,
                 const Dialect& dialect);

}  // namespace wheelwright::import
