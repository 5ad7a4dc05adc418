#include "tools/wheelwright/import/formats/text/row_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/load/ascii_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/formats/text/run_column.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_table_streams = 64;

bool names_a_kind(const std::string& name) {
  constexpr std::array<std::string_view, 22> words{
      "topic", "message", "msg",   "type",   "kind",    "id",      "source", "sensor",
      "frame", "name",    "label", "tag",    "channel", "key",     "signal", "device",
      "motor", "wheel",   "side",  "record", "field",   "variable"};
  const std::string lower = config::lower_case(name);
  return std::ranges::any_of(words, [&](std::string_view word) {
    return lower == word || lower.ends_with("_" + std::string(word)) ||
           lower.ends_with(" " + std::string(word)) || lower.starts_with(std::string(word) + "_");
  });
}

std::size_t count_changes(const std::vector<double>& labels) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < labels.size(); ++i) changes += labels[i] != labels[i - 1] ? 1U : 0U;
  return changes;
}

double variation(const std::vector<double>& values, const std::vector<double>* labels) {
  std::map<double, double> last;
  double sum = 0.0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) continue;
    const auto [before, is_first] = last.try_emplace(labels == nullptr ? 0.0 : (*labels)[row], values[row]);
    if (!is_first) sum += std::abs(values[row] - before->second);
    before->second = values[row];
  }
  return sum;
}

// What a number may stand for: "tag_id", "robot", "id".
bool names_a_thing(const std::string& name) {
  constexpr std::array<std::string_view, 10> words{"id",        "tag",   "marker", "robot", "body",
                                                   "rigidbody", "track", "object", "agent", "vehicle"};
  const std::string lower = config::lower_case(name);
  return std::ranges::any_of(words, [&](std::string_view word) {
    return lower == word || lower.ends_with("_" + std::string(word)) ||
           lower == std::string(word) + "_number" || lower == std::string(word) + "id";
  });
}

bool are_few_whole_numbers(const std::vector<double>& values) {
  std::set<double> numbers;
  for (const double value : values) {
    if (!std::isfinite(value) || value != std::round(value)) return false;
    numbers.insert(value);
    if (numbers.size() > max_table_streams) return false;
  }
  return numbers.size() > 1 && 2 * numbers.size() <= values.size();
}

// Whether a column jumps from label to label and goes evenly by each.
bool parts_motion(const TextTable& table, std::size_t column) {
  constexpr double jumps = 2.0;
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (i == column || table.columns[i].kind == ColumnKind::text) continue;
    if (variation(table.values[i], nullptr) > jumps * variation(table.values[i], &table.values[column]))
      return true;
  }
  return false;
}

// Whether the rows of all labels are those of one thing: a column rises through all of them as a clock does,
// and no column jumps from label to label.
bool are_of_one_thing(const TextTable& table, std::size_t column) {
  constexpr double jumps = 2.0;
  bool has_clock = false;
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (table.columns[i].kind == ColumnKind::text) continue;
    const auto& values = table.values[i];
    if (std::ranges::any_of(values, [](double value) { return !std::isfinite(value); })) return false;
    if (std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end()) has_clock = true;
    if (variation(values, nullptr) > jumps * variation(values, &table.values[column])) return false;
  }
  return has_clock;
}

// Rows of several kinds take turns; a state such as "DRIVE" stands for many rows.
bool parts_rows(const TextTable& table, std::size_t column) {
  const std::size_t labels = table.labels[column].names().size();
  if (table.columns[column].kind != ColumnKind::text || table.labels[column].are_too_many()) return false;
  if (names_a_run(table.columns[column].name) && are_stretches(table.values[column])) return false;
  if (labels < 2 || labels > max_table_streams || 2 * labels > table.rows()) return false;
  return names_a_kind(table.columns[column].name) ||
         (5 * count_changes(table.values[column]) > table.rows() && !are_of_one_thing(table, column));
}

}  // namespace

// Numbers of tags, bodies or robots whose rows take turns, and between which a column jumps.
void label_numbers(TextTable& table) {
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (table.columns[i].kind != ColumnKind::number || !names_a_thing(table.columns[i].name)) continue;
    auto& values = table.values[i];
    if (!are_few_whole_numbers(values) || 5 * count_changes(values) < table.rows() || !parts_motion(table, i))
      continue;
    const std::string name = table.columns[i].name;
    for (double& value : values) value = table.labels[i].number_of(name + " " + config::plain_number(value));
    table.columns[i].kind = ColumnKind::text;
  }
}

std::optional<std::size_t> find_kind_column(const TextTable& table) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (!parts_rows(table, i)) continue;
    const bool is_better = !best || table.labels[i].names().size() > table.labels[*best].names().size();
    if (is_better) best = i;
  }
  return best;
}

}  // namespace wheelwright::import
