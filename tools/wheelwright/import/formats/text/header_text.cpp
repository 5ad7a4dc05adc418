#include "tools/wheelwright/import/formats/text/header_text.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"
#include "tools/wheelwright/import/formats/text/number_text.hpp"
#include "tools/wheelwright/import/formats/text/table_layout.hpp"
#include "tools/wheelwright/import/formats/text/unit_text.hpp"

namespace wheelwright::import {
namespace {

using Names = std::vector<std::string>;

Names as_names(const std::vector<std::string_view>& cells) {
  Names names;
  for (const std::string_view cell : cells) names.push_back(unescape_quotes(cell));
  return names;
}

bool has_bracket_first(std::string_view text) {
  return text.starts_with('[') || text.starts_with('(');
}

// Words parted by blanks, a unit in brackets with the word before it.
Names split_words(std::string_view text) {
  Dialect blanks;
  blanks.separator = ' ';
  std::vector<std::string_view> cells;
  split_row(text, blanks, cells);
  Names names;
  for (const std::string_view cell : cells) {
    if (has_bracket_first(cell) && !names.empty()) {
      names.back() += " " + std::string(cell);
    } else {
      names.emplace_back(cell);
    }
  }
  return names;
}

// Names of several words, parted by tabulators or at least two blanks.
Names split_wide(std::string_view text) {
  Names names;
  while (!text.empty()) {
    const auto end = std::min({text.find('\t'), text.find("  "), text.size()});
    names.emplace_back(trim(text.substr(0, end)));
    text = trim(text.substr(end));
  }
  return names;
}

bool are_names(const Names& names, char decimal) {
  return std::ranges::none_of(
      names, [&](const std::string& name) { return read_number(name, decimal).has_value(); });
}

std::set<std::string> repeated(const Names& names) {
  std::set<std::string> seen;
  std::set<std::string> twice;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) twice.insert(name);
  }
  return twice;
}

}  // namespace

std::vector<std::string> comment_header(std::string_view comment, const Dialect& dialect, std::size_t width) {
  const std::string_view text = comment_text(comment);
  const std::size_t stamps = dialect.rows_are_stamped ? 1 : 0;
  if (key_and_value(text) || width <= stamps) return {};
  const auto fits = [&](const Names& names) {
    return names.size() + stamps == width && are_names(names, dialect.decimal);
  };
  Names names;
  for (const char separator : {dialect.separator, ',', ';', '\t'}) {
    Dialect candidate;
    candidate.separator = separator;
    std::vector<std::string_view> cells;
    split_row(text, candidate, cells);
    names = as_names(cells);
    if (separator == ' ' || !fits(names)) names.clear();
    if (!names.empty()) break;
  }
  if (names.empty() && fits(split_wide(text))) names = split_wide(text);
  if (names.empty() && fits(split_words(text))) names = split_words(text);
  if (!names.empty() && stamps == 1) names.insert(names.begin(), "stamp");
  return names;
}

std::optional<std::pair<std::string, std::string>> key_and_value(std::string_view text) {
  constexpr std::size_t longest_key = 60;
  const auto sign = text.find_first_of(":=");
  if (sign == std::string_view::npos || sign == 0) return std::nullopt;
  const std::string_view key = trim(text.substr(0, sign));
  const bool is_key = !key.empty() && key.size() <= longest_key &&
                      std::isalpha(static_cast<unsigned char>(key.front())) != 0 &&
                      key.find_first_of(",;\t|\"") == std::string_view::npos;
  if (!is_key) return std::nullopt;
  return std::pair(std::string(key), std::string(trim(text.substr(sign + 1))));
}

bool is_units_row(const std::vector<std::string>& cells) {
  std::size_t units = 0;
  std::size_t others = 0;
  for (const std::string& cell : cells) {
    if (is_unit(bare_unit(cell))) {
      ++units;
    } else if (!is_missing(cell)) {
      ++others;
    }
  }
  return units > 0 && others == 0;
}

std::string bare_unit(std::string_view cell) {
  cell = trim(cell);
  if (is_missing(cell)) return {};
  const bool has_brackets = cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') ||
                                                (cell.front() == '(' && cell.back() == ')'));
  return std::string(has_brackets ? trim(cell.substr(1, cell.size() - 2)) : cell);
}

bool join_upper_names(const std::vector<std::string>& upper, std::vector<std::string>& names) {
  const std::set<std::string> twice = repeated(names);
  if (twice.empty() || upper.size() != names.size()) return false;
  Names joined = names;
  std::string group;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!upper[i].empty()) group = upper[i];
    if (!group.empty() && !names[i].empty()) joined[i] = group + "." + names[i];
    if (names[i].empty()) joined[i] = upper[i];
  }
  names = joined;
  return true;
}

std::vector<Column> name_columns(const std::vector<std::string>& header, const std::vector<ColumnKind>& kinds,
                                 std::vector<std::string>& remarks) {
  std::vector<Column> columns;
  Names bare;
  for (const std::string& name : header) bare.push_back(split_unit(name).name);
  const std::set<std::string> twice = repeated(bare);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    Column column{std::ranges::find(bare, number) == bare.end() ? number : "column " + number, {}, kinds[i]};
    if (i < header.size() && !trim(header[i]).empty()) {
      auto [name, unit] = split_unit(header[i]);
      column.name = twice.contains(name) ? std::string(trim(header[i])) : std::move(name);
      column.unit = std::move(unit);
    }
    const std::string as_it_is = column.name;
    for (std::size_t count = 2; !taken.insert(column.name).second; ++count)
      column.name = as_it_is + "." + std::to_string(count);
    if (column.name != as_it_is) {
      remarks.push_back("column " + std::to_string(i + 1) + " has the name '" + config::excerpt(as_it_is) +
                        "' of another: called '" + config::excerpt(column.name) + "'");
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace wheelwright::import
