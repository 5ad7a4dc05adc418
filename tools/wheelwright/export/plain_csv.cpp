#include "tools/wheelwright/export/plain_csv.hpp"

#include <vector>

#include "config/load/drive_log_file.hpp"

namespace wheelwright::tools {
namespace {

using config::CsvTable;

// Columns of `table` that `other` has not.
std::vector<std::size_t> columns_beside(const CsvTable& table, const CsvTable* other) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    if (other == nullptr || !other->has(table.columns()[i])) kept.push_back(i);
  }
  return kept;
}

// The row of `table` that belongs to each row of `times`; rows() where there is none.
std::vector<std::size_t> partners(const std::vector<double>& times, const CsvTable& table) {
  const auto others = table.numbers("t");
  std::vector<std::size_t> rows;
  std::size_t row = 0;
  for (const double t : times) {
    while (row < others.size() && others[row] < t) ++row;
    rows.push_back(row < others.size() && others[row] == t ? row : others.size());
  }
  return rows;
}

}  // namespace

std::string to_plain_csv(const RecordedRun& run) {
  const CsvTable& first = run.drive ? *run.drive : *run.poses;
  const CsvTable* second = run.drive && run.poses ? &*run.poses : nullptr;
  const auto second_columns = second ? columns_beside(*second, &first) : std::vector<std::size_t>{};
  const auto second_rows = second ? partners(first.numbers("t"), *second) : std::vector<std::size_t>{};

  std::string text;
  for (const auto& column : first.columns()) text += (text.empty() ? "" : ",") + column;
  for (const auto column : second_columns) text += "," + second->columns()[column];
  text += '\n';
  for (std::size_t row = 0; row < first.rows(); ++row) {
    for (std::size_t column = 0; column < first.columns().size(); ++column) {
      if (column > 0) text += ',';
      text += first.text(row, column);
    }
    for (const auto column : second_columns) {
      text += ',';
      if (second_rows[row] < second->rows()) text += second->text(second_rows[row], column);
    }
    text += '\n';
  }
  return text;
}

}  // namespace wheelwright::tools
