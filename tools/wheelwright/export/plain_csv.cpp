#include "tools/wheelwright/export/plain_csv.hpp"

#include <optional>
#include <vector>

#include "config/load/drive_log_file.hpp"

namespace wheelwright::tools {
namespace {

using config::CsvTable;

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

// What the pose log adds to each row of the drive log.
class Beside {
 public:
  Beside(const CsvTable& table, const CsvTable& first)
      : table_(table), rows_(partners(first.numbers("t"), table)) {
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
      if (!first.has(table.columns()[i])) columns_.push_back(i);
    }
  }
  void add_names(std::string& text) const {
    for (const auto column : columns_) text += "," + table_.columns()[column];
  }
  void add_fields(std::size_t row, std::string& text) const {
    for (const auto column : columns_) {
      text += ',';
      if (rows_[row] < table_.rows()) text += table_.text(rows_[row], column);
    }
  }

 private:
  const CsvTable& table_;
  std::vector<std::size_t> rows_;
  std::vector<std::size_t> columns_;
};

}  // namespace

std::string to_plain_csv(const RecordedRun& run) {
  const CsvTable& first = run.drive ? *run.drive : *run.poses;
  std::optional<Beside> beside;
  if (run.drive && run.poses) beside.emplace(*run.poses, first);

  std::string text;
  for (const auto& column : first.columns()) text += (text.empty() ? "" : ",") + column;
  if (beside) beside->add_names(text);
  text += '\n';
  for (std::size_t row = 0; row < first.rows(); ++row) {
    for (std::size_t column = 0; column < first.columns().size(); ++column) {
      if (column > 0) text += ',';
      text += first.text(row, column);
    }
    if (beside) beside->add_fields(row, text);
    text += '\n';
  }
  return text;
}

}  // namespace wheelwright::tools
