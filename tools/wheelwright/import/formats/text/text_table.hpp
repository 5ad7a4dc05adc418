// The rows of a table as columns of numbers; what the columns are is in table_layout.hpp.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/formats/text/line_tally.hpp"
#include "tools/wheelwright/import/formats/text/table_layout.hpp"

namespace wheelwright::import {

// The texts of a column, in the order in which they first occur; a row holds the number of its label.
class Labels {
 public:
  static constexpr std::size_t max_labels = 256;
  double number_of(std::string_view text);
  const std::vector<std::string>& names() const { return names_; }
  bool are_too_many() const { return are_too_many_; }

 private:
  std::map<std::string, std::size_t, std::less<>> numbers_;
  std::vector<std::string> names_;
  std::size_t last_ = 0;  // most rows have the label of the row before
  bool are_too_many_ = false;
};

class TextTable {
 public:
  TextTable(std::vector<Column> columns, std::vector<std::string> header);

  enum class Taken { row, text };  // text: nothing that a number column could read
  // Takes a row whose cells are as many as the columns, or says that it is none.
  Taken take(const std::vector<std::string_view>& cells, const Line& line, const Dialect& dialect);
  void reserve(std::size_t rows);
  void say_unread_cells(std::vector<std::string>& remarks) const;

  std::size_t width() const { return columns.size(); }
  std::size_t rows() const { return places.size(); }

  std::vector<Column> columns;
  std::vector<std::string> header;          // as it stands in the file; empty without one
  std::vector<std::vector<double>> values;  // by column; of texts the numbers of their labels
  std::vector<Labels> labels;               // by column
  std::vector<std::size_t> places;          // line of each row

 private:
  std::vector<double> row_;
  std::vector<std::size_t> unread_;  // columns of the row whose cell is no number
  std::vector<LineTally> unread_cells_;
};

}  // namespace wheelwright::import
