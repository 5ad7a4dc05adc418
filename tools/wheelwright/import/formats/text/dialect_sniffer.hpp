// Finds how the rows of a table are parted into cells, and how its numbers are written: every candidate is
// tried on lines from several places of the file, and the one stays by which most lines have the same number
// of cells, and most cells are numbers or times.
#pragma once

#include <cstddef>
#include <string>

#include "tools/wheelwright/import/formats/text/row_splitter.hpp"
#include "tools/wheelwright/import/formats/text/text_sample.hpp"

namespace wheelwright::import {

struct SniffedTable {
  Dialect dialect;
  std::size_t width = 0;         // cells of a row
  double share_of_rows = 0.0;    // of the lines that have this width
  double share_of_values = 0.0;  // of the cells that are not empty: numbers and times
  double score() const { return share_of_rows * share_of_values; }
};

// `given_separator`: of a line "sep=;" at the head of the file; '\0' where there is none.
SniffedTable sniff_table(const TextSample& sample, char given_separator);

// "';' between fields, decimal comma".
std::string in_words(const Dialect& dialect);

// The width of a row without the empty cells at its end that exceed `width`.
std::size_t width_of(const std::vector<std::string_view>& cells, std::size_t width);

}  // namespace wheelwright::import
