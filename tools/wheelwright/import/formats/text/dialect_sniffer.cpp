#include "tools/wheelwright/import/formats/text/dialect_sniffer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/text/number_text.hpp"

namespace wheelwright::import {
namespace {

using Cells = std::vector<std::string_view>;
using Lines = std::vector<std::string_view>;

bool is_more_than_half(std::size_t part, std::size_t whole) {
  return whole > 0 && 2 * part > whole;
}

std::size_t count_lines(const Lines& lines, bool (*matches)(std::string_view)) {
  return static_cast<std::size_t>(std::ranges::count_if(lines, matches));
}

// One pair of quotes around all of the line, as where a CSV was written into one column of another.
bool is_quoted_row(std::string_view line) {
  line = trim(line);
  if (line.size() < 2 || line.front() != '"' || line.back() != '"') return false;
  const std::string_view inside = line.substr(1, line.size() - 2);
  return inside.find('"') == std::string_view::npos &&
         inside.find_first_of(",;\t| ") != std::string_view::npos;
}

bool is_stamped(std::string_view line) {
  return stamp_prefix(line).has_value();
}

// The number of cells that most lines have, without the empty one behind a separator at the end of each row.
std::size_t most_frequent_width(const Lines& lines, const Dialect& dialect) {
  struct Count {
    std::size_t lines = 0;
    bool ends_filled = false;
  };
  std::map<std::size_t, Count> counts;
  Cells cells;
  for (const std::string_view line : lines) {
    split_row(line, dialect, cells);
    if (cells.empty()) continue;
    Count& count = counts[cells.size()];
    ++count.lines;
    count.ends_filled = count.ends_filled || !cells.back().empty();
  }
  const auto most = std::ranges::max_element(counts, [](const auto& a, const auto& b) {
    return std::pair(a.second.lines, a.first) < std::pair(b.second.lines, b.first);
  });
  if (most == counts.end()) return 0;
  return most->first > 1 && !most->second.ends_filled ? most->first - 1 : most->first;
}

SniffedTable try_dialect(const Lines& lines, const Dialect& dialect) {
  SniffedTable table{dialect};
  table.width = most_frequent_width(lines, dialect);
  if (lines.empty() || table.width == 0 || table.width > max_columns) return table;
  std::size_t rows = 0;
  std::size_t values = 0;
  std::size_t filled = 0;
  Cells cells;
  for (const std::string_view line : lines) {
    split_row(line, dialect, cells);
    if (width_of(cells, table.width) != table.width) continue;
    ++rows;
    for (const std::string_view cell : cells) {
      if (is_missing(cell)) continue;
      ++filled;
      if (read_number(cell, dialect.decimal) || read_time(cell, dialect.date_order)) ++values;
    }
  }
  table.share_of_rows = static_cast<double>(rows) / static_cast<double>(lines.size());
  if (filled > 0) table.share_of_values = static_cast<double>(values) / static_cast<double>(filled);
  return table;
}

DateOrder find_date_order(const Lines& lines, const Dialect& dialect) {
  Cells cells;
  for (const std::string_view line : lines) {
    split_row(line, dialect, cells);
    for (const std::string_view cell : cells) {
      if (const auto order = order_shown_by(cell)) return *order;
    }
  }
  return DateOrder::month_first;
}

// Whether the sign that is not the decimal one stands between groups of three digits wherever it stands, and
// in all numbers from 1000 on of the columns that have it: it is no decimal sign then.
bool are_grouped(const Lines& lines, const Dialect& dialect) {
  constexpr std::size_t min_grouped = 3;
  constexpr double thousand = 1000.0;
  std::map<std::size_t, std::size_t> grouped;
  std::set<std::size_t> with_plain_thousands;
  Cells cells;
  for (const std::string_view line : lines) {
    split_row(line, dialect, cells);
    for (std::size_t i = dialect.rows_are_stamped ? 1 : 0; i < cells.size(); ++i) {
      const Grouping grouping = grouping_of(cells[i], dialect.decimal);
      if (grouping == Grouping::other) return false;
      if (grouping == Grouping::grouped) ++grouped[i];
      if (grouping == Grouping::none &&
          std::abs(read_number(cells[i], dialect.decimal).value_or(0.0)) >= thousand)
        with_plain_thousands.insert(i);
    }
  }
  std::size_t count = 0;
  for (const auto& [column, cells_of_it] : grouped) {
    if (with_plain_thousands.contains(column)) return false;
    count += cells_of_it;
  }
  return count >= min_grouped;
}

}  // namespace

std::size_t width_of(const std::vector<std::string_view>& cells, std::size_t width) {
  std::size_t count = cells.size();
  while (count > width && cells[count - 1].empty()) --count;
  return count;
}

SniffedTable sniff_table(const TextSample& sample, char given_separator) {
  const Lines& lines = sample.contents;
  Dialect common;
  common.rows_are_stamped = is_more_than_half(count_lines(lines, is_stamped), lines.size());
  common.rows_are_quoted = is_more_than_half(count_lines(lines, is_quoted_row), lines.size());
  SniffedTable best;
  for (const char separator : {',', ';', '\t', '|', ' ', '\0'}) {
    if (given_separator != '\0' && separator != given_separator) continue;
    for (const char decimal : {'.', ','}) {
      if (separator == ',' && decimal == ',') continue;
      Dialect dialect = common;
      dialect.separator = separator;
      dialect.decimal = decimal;
      const SniffedTable table = try_dialect(lines, dialect);
      const std::size_t fewest = (separator == '\0' ? 1U : 2U) + (common.rows_are_stamped ? 1U : 0U);
      if (table.width >= fewest && table.score() > best.score() + 1e-9) best = table;
    }
  }
  best.dialect.date_order = find_date_order(lines, best.dialect);
  best.dialect.has_groups = are_grouped(lines, best.dialect);
  return best;
}

std::string in_words(const Dialect& dialect) {
  std::string words;
  switch (dialect.separator) {
    case '\t':
      words = "tabulators between fields";
      break;
    case ' ':
      words = "blanks between fields";
      break;
    case '\0':
      words = "one column";
      break;
    default:
      words = std::string("'") + dialect.separator + "' between fields";
  }
  if (dialect.decimal == ',') words += ", decimal comma";
  if (dialect.has_groups)
    words += std::string(", '") + (dialect.decimal == '.' ? ',' : '.') + "' between thousands";
  if (dialect.rows_are_quoted) words += ", whole rows in quotes";
  if (dialect.rows_are_stamped) words += ", a stamp before each row";
  return words;
}

}  // namespace wheelwright::import
