#include "tools/wheelwright/import/formats/text/decimal_comma.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "tools/wheelwright/import/formats/text/row_splitter.hpp"

namespace wheelwright::import {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t min_rows = 3;

bool are_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_integer(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return are_digits(text);
}

// What the rows look like if each pair of cells is one number.
struct Pairs {
  std::size_t rows = 0;
  std::size_t width = 0;     // the same in each row
  bool are_possible = true;  // whole numbers, the second of each pair without a sign
  bool have_zeros = false;   // "05" in the second: no program writes a whole number so
  bool have_many = false;    // "050": no date or time does either
  std::size_t carries = 0;   // rows at which the second falls while the first goes up by one
  bool rise = true;          // as one number none is below the one before
};

// One pair of cells as a number, with as many decimals as stand there.
double as_decimal(std::string_view whole, std::string_view part) {
  double value = 0.0;
  double decimals = 0.0;
  const bool is_negative = whole.starts_with('-');
  if (is_negative || whole.starts_with('+')) whole.remove_prefix(1);
  for (const char digit : whole) value = 10.0 * value + (digit - '0');
  for (const char digit : part) decimals = 10.0 * decimals + (digit - '0');
  value += decimals / std::pow(10.0, static_cast<double>(part.size()));
  return is_negative ? -value : value;
}

Pairs examine_pairs(const TextSample& sample, const Dialect& dialect) {
  Pairs pairs;
  Cells cells;
  std::string_view whole_before;
  std::string_view part_before;
  for (const std::string_view line : sample.contents) {
    if (line.find('"') != std::string_view::npos) pairs.are_possible = false;
    split_row(line, dialect, cells);
    if (dialect.rows_are_stamped && !cells.empty()) cells.erase(cells.begin());
    if (cells.empty() || !std::ranges::any_of(cells, is_integer)) continue;  // names
    if (pairs.rows++ == 0) pairs.width = cells.size();
    if (cells.size() != pairs.width || cells.size() % 2 != 0) pairs.are_possible = false;
    for (std::size_t i = 0; i < cells.size() && pairs.are_possible; ++i) {
      pairs.are_possible = i % 2 == 0 ? is_integer(cells[i]) : are_digits(cells[i]);
      if (i % 2 == 0 || cells[i].front() != '0') continue;
      pairs.have_zeros = pairs.have_zeros || cells[i].size() > 1;
      pairs.have_many = pairs.have_many || cells[i].size() > 2;
    }
    if (!pairs.are_possible || cells.size() != 2) continue;
    if (!part_before.empty()) {
      const double before = as_decimal(whole_before, part_before);
      const double now = as_decimal(cells[0], cells[1]);
      pairs.rise = pairs.rise && now >= before;
      const double whole_step = as_decimal(cells[0], {}) - as_decimal(whole_before, {});
      if (whole_step == 1.0 && as_decimal(cells[1], {}) < as_decimal(part_before, {})) ++pairs.carries;
    }
    whole_before = cells[0];
    part_before = cells[1];
  }
  if (pairs.rows < min_rows) pairs.are_possible = false;
  return pairs;
}

std::size_t names_above(const TextSample& sample, const Dialect& dialect) {
  if (sample.contents.empty()) return 0;
  Cells cells;
  split_row(sample.contents.front(), dialect, cells);
  if (dialect.rows_are_stamped && !cells.empty()) cells.erase(cells.begin());
  const bool are_names = std::ranges::none_of(cells, is_integer);
  return are_names ? width_of(cells, 1) : 0;
}

}  // namespace

CommaVerdict judge_comma(const TextSample& sample, const Dialect& dialect,
                         const std::vector<std::string>& header) {
  if (dialect.separator != ',' || !header.empty()) return {};
  const Pairs pairs = examine_pairs(sample, dialect);
  if (!pairs.are_possible) return {};
  const std::size_t names = names_above(sample, dialect);
  if (pairs.width == 2 && (names == 1 || pairs.have_zeros)) {
    return {CommaMeaning::decimal,
            "the comma is taken for the decimal sign of one column (" +
                std::string(names == 1 ? "there is one name above it" : "zeros follow it, as in 1,05") + ")"};
  }
  // A counter beside another does not fall whenever that goes up by one.
  constexpr std::size_t min_carries = 3;
  if (pairs.width == 2 && pairs.rise && pairs.carries >= min_carries) {
    return {
        CommaMeaning::decimal,
        "the comma is taken for the decimal sign of one column: as such its numbers never fall, while what "
        "follows it starts again whenever what precedes it goes up by one"};
  }
  if (pairs.width > 2 && (names == pairs.width / 2 || pairs.have_many)) {
    return {CommaMeaning::both, "the comma seems to be both the separator and the decimal sign (" +
                                    std::to_string(pairs.width) + " fields a row" +
                                    (names > 0 ? " for " + std::to_string(names) + " names" : "") +
                                    "); write ';' between the fields, or decimal points"};
  }
  if (pairs.width > 2) return {};
  return {CommaMeaning::separator,
          "the comma is taken for the separator of two columns of whole numbers; it could also be a decimal "
          "sign"};
}

SniffedTable as_single_decimal_column(SniffedTable table) {
  table.dialect.separator = '\0';
  table.dialect.decimal = ',';
  table.width = table.dialect.rows_are_stamped ? 2 : 1;
  return table;
}

}  // namespace wheelwright::import
