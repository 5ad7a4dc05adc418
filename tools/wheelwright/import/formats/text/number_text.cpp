#include "tools/wheelwright/import/formats/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/formats/text/unit_text.hpp"

namespace wheelwright::import {
namespace {

using config::is_digit;
using config::to_lower;
using config::trim;

constexpr std::size_t longest_number = 400;  // characters

bool equals_word(std::string_view cell, std::string_view word) {
  return std::ranges::equal(cell, word, {}, to_lower);
}

std::optional<double> read_plain(std::string_view cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_whole = end == cell.data() + cell.size();
  if (!is_whole || (error != std::errc() && error != std::errc::result_out_of_range)) return std::nullopt;
  if (error == std::errc::result_out_of_range) return 0.0;  // 1e-400, or too large to mean anything
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Nearly every number of a log: up to 15 digits with a point among them. Both the digits and the power of ten
// are exact as doubles, so their quotient is rounded once, as from_chars would; only faster.
std::optional<double> read_short_decimal(std::string_view cell) {
  constexpr std::size_t max_digits = 15;
  constexpr std::array<double, max_digits + 1> powers_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                             1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool is_negative = !cell.empty() && cell.front() == '-';
  if (is_negative) cell.remove_prefix(1);
  if (cell.size() > max_digits || cell.empty()) return std::nullopt;
  std::uint64_t digits = 0;
  std::size_t decimals = 0;
  bool has_point = false;
  for (const char character : cell) {
    if (is_digit(character)) {
      digits = digits * 10 + static_cast<std::uint64_t>(character - '0');
      decimals += has_point ? 1U : 0U;
    } else if (character == '.' && !has_point) {
      has_point = true;
    } else {
      return std::nullopt;
    }
  }
  if (has_point && cell.size() == 1) return std::nullopt;
  const double value = static_cast<double>(digits) / powers_of_ten[decimals];
  return is_negative ? -value : value;
}

// A number below zero that was written without its sign: 18446744073709551115 is -501.
std::optional<double> read_unsigned_64(std::string_view cell) {
  constexpr std::size_t digits_of_64_bits = 20;
  if (cell.size() != digits_of_64_bits) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return -static_cast<double>(~value + 1);
}

std::optional<double> read_hexadecimal(std::string_view cell) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data() + 2, cell.data() + cell.size(), value, 16);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return static_cast<double>(value);
}

// Groups of three digits behind the first, which has one to three.
bool has_groups(std::string_view whole, char separator) {
  const auto first = whole.find(separator);
  if (first == std::string_view::npos || first == 0 || first > 3) return false;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const bool is_at_separator = i >= first && (i - first) % 4 == 0;
    if (is_at_separator ? whole[i] != separator : !is_digit(whole[i])) return false;
  }
  return (whole.size() - first) % 4 == 0;
}

// "1'234.5" and "1 234,5" without the signs between their groups; empty where there are none, or where they
// stand elsewhere.
std::string without_group_signs(std::string_view cell, char decimal) {
  constexpr std::array<std::string_view, 6> signs{
      "'", " ", "\xc2\xa0", "\xe2\x80\xaf", "\xe2\x80\x89", "\xe2\x80\x99"};
  for (const std::string_view sign : signs) {
    if (cell.find(sign) == std::string_view::npos) continue;
    std::string text(cell);
    for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos; ++at)
      text.replace(at, sign.size(), 1, '\'');
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    const std::string_view whole = std::string_view(text).substr(begin, text.find(decimal) - begin);
    if (!has_groups(whole, '\'')) return {};
    std::erase(text, '\'');
    return text;
  }
  return {};
}

// The number without its thousands separators and with a decimal point; empty where it has other characters.
std::string_view plain_form(std::string_view cell, char decimal, bool grouped,
                            std::array<char, longest_number>& buffer) {
  if (cell.size() > buffer.size()) return {};
  const char separator = decimal == '.' ? ',' : '.';
  const std::string_view unsigned_part = cell.front() == '-' ? cell.substr(1) : cell;
  const std::string_view whole = unsigned_part.substr(0, unsigned_part.find(decimal));
  const bool has_separators = whole.find(separator) != std::string_view::npos;
  const bool is_unambiguous =
      grouped || whole.size() < unsigned_part.size() || std::ranges::count(whole, separator) > 1;
  if (has_separators && !(is_unambiguous && has_groups(whole, separator))) return {};
  std::size_t length = 0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const char character = cell[i];
    if (has_separators && character == separator) continue;
    if (character == '.' && decimal == ',') return {};
    const bool is_decimal = decimal == ',' && character == ',';
    if (is_decimal && (i + 1 == cell.size() || !is_digit(cell[i + 1]))) return {};
    buffer.at(length++) = is_decimal ? '.' : character;
  }
  return {buffer.data(), length};
}

std::optional<double> read_truth(std::string_view cell) {
  if (equals_word(cell, "true")) return 1.0;
  if (equals_word(cell, "false")) return 0.0;
  return std::nullopt;
}

}  // namespace

std::optional<double> read_number(std::string_view cell, char decimal, bool grouped) {
  if (cell.empty()) return std::nullopt;
  if (cell.front() == '+') {
    cell.remove_prefix(1);
    if (cell.empty() || cell.front() == '-') return std::nullopt;
  }
  if (cell.starts_with("0x") || cell.starts_with("0X")) return read_hexadecimal(cell);
  const char first = cell.front();
  if (!is_digit(first) && first != '-' && first != '.' && first != ',') return read_truth(cell);
  if (decimal == '.') {
    if (const auto number = read_short_decimal(cell)) return number;
    if (const auto number = read_unsigned_64(cell)) return number;
    if (const auto number = read_plain(cell)) return number;
  }
  std::array<char, longest_number> buffer;
  if (const std::string joined = without_group_signs(cell, decimal); !joined.empty())
    return read_number(joined, decimal);
  const std::string_view plain = plain_form(cell, decimal, grouped, buffer);
  return plain.empty() ? std::nullopt : read_plain(plain);
}

std::optional<NumberWithUnit> read_number_with_unit(std::string_view cell, char decimal) {
  const auto begin = cell.find_last_of("0123456789.");
  if (begin == std::string_view::npos || begin + 1 == cell.size() || cell.size() > longest_number)
    return std::nullopt;
  const std::string_view behind = cell.substr(begin + 1);
  const std::string_view unit = trim(behind);
  if (!is_unit(unit) || (unit.size() == 1 && behind.size() == 1)) return std::nullopt;
  const auto value = read_number(cell.substr(0, begin + 1), decimal);
  return value ? std::optional(NumberWithUnit{*value, unit}) : std::nullopt;
}

Grouping grouping_of(std::string_view cell, char decimal) {
  const char separator = decimal == '.' ? ',' : '.';
  if (cell.find(separator) == std::string_view::npos) return Grouping::none;
  if (cell.find_first_not_of("0123456789,.-") != std::string_view::npos) return Grouping::none;
  if (cell.starts_with('-')) cell.remove_prefix(1);
  const std::string_view whole = cell.substr(0, cell.find(decimal));
  return !whole.starts_with('0') && has_groups(whole, separator) ? Grouping::grouped : Grouping::other;
}

bool is_missing(std::string_view cell) {
  if (cell.empty()) return true;
  constexpr std::array<std::string_view, 30> words{
      "-",    "--",        "nan",    "-nan",    "na",      "n/a",    "null",     "none",
      "nil",  "?",         ".",      "inf",     "-inf",    "+inf",   "infinity", "-infinity",
      "#n/a", "#na",       "#ref!",  "#div/0!", "#value!", "#num!",  "#name?",   "#null!",
      "nat",  "-nan(ind)", "1.#inf", "1.#ind",  "1.#qnan", "-1.#ind"};
  constexpr std::size_t longest_word = 9;
  if (cell.size() > longest_word) return false;
  return std::ranges::any_of(words, [cell](std::string_view word) { return equals_word(cell, word); });
}

}  // namespace wheelwright::import
