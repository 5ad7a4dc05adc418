#include "config/load/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <new>

#include "config/load/ascii_text.hpp"
#include "config/load/cut_row.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"

namespace wheelwright::config {
namespace {

constexpr double largest_value = 1e12;  // of any column: what is larger is garbage

template <typename Take>
void for_each_field(std::string_view line, Take take) {
  while (true) {
    const auto comma = line.find(',');
    take(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable CsvTable::load(const std::filesystem::path& path) {
  try {
    return parse(read_text_or_throw<LogError>(path, log_file), path.string());
  } catch (const std::bad_alloc&) {
    throw LogError(path.string() + ": is too large for the free memory of this machine; split the file");
  }
}

CsvTable CsvTable::parse(std::string text, std::string name) {
  CsvTable table;
  table.text_ = std::make_unique<const std::string>(std::move(text));
  table.name_ = std::move(name);
  std::string_view rest = *table.text_;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const auto end = rest.find('\n');
    table.take_line(trim(rest.substr(0, end)), number, end == std::string_view::npos);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  if (table.columns_.empty()) throw LogError(table.name_ + ": has no header row that names its columns");
  if (table.fields_.empty()) throw LogError(table.name_ + ": holds no rows");
  return table;
}

void CsvTable::take_line(std::string_view line, std::size_t number, bool is_open_ended) {
  if (line.empty()) return;
  if (line.front() == '#') {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) return;
    metadata_.emplace(trim(line.substr(1, colon - 1)), trim(line.substr(colon + 1)));
  } else if (columns_.empty()) {
    for_each_field(line, [this](std::string_view field) { columns_.emplace_back(field); });
  } else {
    const std::size_t before = fields_.size();
    for_each_field(line, [this](std::string_view field) { fields_.push_back(field); });
    lines_.push_back(number);
    const std::size_t count = fields_.size() - before;
    const bool has_row_above = before > 0;
    if (is_open_ended && (count < columns_.size() ||
                          (has_row_above && has_lost_figures(fields_.back(), fields_[before - 1])))) {
      fail(lines_.size() - 1, std::string(cut_row_text));
    }
    if (count != columns_.size()) {
      throw LogError(name_ + ":" + std::to_string(number) + ": has " + std::to_string(count) +
                     " fields, but the header names " + std::to_string(columns_.size()) + " columns");
    }
  }
}

const std::string& CsvTable::metadata(const std::string& key) const {
  static const std::string absent;
  const auto found = metadata_.find(key);
  return found == metadata_.end() ? absent : found->second;
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto found = std::ranges::find(columns_, column);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

void CsvTable::fail(std::size_t row, const std::string& what) const {
  throw LogError(name_ + ":" + std::to_string(lines_[row]) + ": " + what);
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string_view field = text(row, column);
  if (field.empty()) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool is_number = error == std::errc() && end == field.data() + field.size();
  if (!is_number || !(std::abs(value) <= largest_value)) {
    fail(row, "'" + excerpt(columns_[column]) + "' is '" + excerpt(field) + "', but must be a number" +
                  (is_number ? " of at most 1e12 in size" : ""));
  }
  return value;
}

std::vector<double> CsvTable::numbers(std::string_view column) const {
  const auto at = find(column);
  if (!at) throw LogError(name_ + ": has no column '" + std::string(column) + "'");
  std::vector<double> values(rows());
  for (std::size_t row = 0; row < values.size(); ++row) {
    values[row] = number(row, *at).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

}  // namespace wheelwright::config
