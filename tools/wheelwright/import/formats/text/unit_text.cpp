#include "tools/wheelwright/import/formats/text/unit_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {
namespace {

constexpr std::array<std::string_view, 49> symbols{"s",
                                                   "mph",
                                                   "yd",
                                                   "ms",
                                                   "us",
                                                   "ns",
                                                   "\xc2\xb5s",
                                                   "\xce\xbcs",
                                                   "h",
                                                   "min",
                                                   "m",
                                                   "mm",
                                                   "cm",
                                                   "dm",
                                                   "km",
                                                   "in",
                                                   "ft",
                                                   "deg",
                                                   "\xc2\xb0",
                                                   "rad",
                                                   "mrad",
                                                   "rpm",
                                                   "rps",
                                                   "rev",
                                                   "hz",
                                                   "khz",
                                                   "v",
                                                   "mv",
                                                   "a",
                                                   "ma",
                                                   "w",
                                                   "n",
                                                   "nm",
                                                   "g",
                                                   "kg",
                                                   "t",
                                                   "ut",
                                                   "\xc2\xb5t",
                                                   "k",
                                                   "c",
                                                   "%",
                                                   "px",
                                                   "pwm",
                                                   "\xc2\xb0"
                                                   "c",
                                                   "cps",
                                                   "pct",
                                                   "sec",
                                                   "msec",
                                                   "usec"};
constexpr std::array<std::string_view, 26> words{
    "second",      "seconds", "secs",   "millisecond", "milliseconds", "microsecond", "microseconds",
    "nanoseconds", "minutes", "hours",  "metre",       "metres",       "meter",       "meters",
    "degree",      "degrees", "radian", "radians",     "count",        "counts",      "tick",
    "ticks",       "pulse",   "pulses", "volt",        "volts"};

bool is_unit_letter(char character) {
  const auto code = static_cast<unsigned char>(character);
  return std::isalpha(code) != 0 || code >= 0x80 || character == '%';
}

bool is_symbol(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char character) {
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
  });
  return std::ranges::find(symbols, lower) != symbols.end() || std::ranges::find(words, lower) != words.end();
}

}  // namespace

bool is_unit(std::string_view text) {
  constexpr std::size_t longest_unit = 24;
  constexpr std::string_view between = "/*^ -.()0123456789";
  if (text.empty() || text.size() > longest_unit) return false;
  bool has_symbol = false;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_unit_letter(text[end])) ++end;
    if (end == at) {
      if (between.find(text[at]) == std::string_view::npos) return false;
      ++at;
      continue;
    }
    if (!is_symbol(text.substr(at, end - at))) return false;
    has_symbol = true;
    at = end;
  }
  return has_symbol;
}

NameAndUnit split_unit(std::string_view name) {
  name = trim(name);
  if (name.empty() || (name.back() != ']' && name.back() != ')')) return {std::string(name), {}};
  const auto open = name.rfind(name.back() == ']' ? '[' : '(');
  if (open == std::string_view::npos || open == 0) return {std::string(name), {}};
  const std::string_view unit = trim(name.substr(open + 1, name.size() - open - 2));
  const std::string_view before = trim(name.substr(0, open));
  if (before.empty() || (!is_unit(unit) && !unit.empty())) return {std::string(name), {}};
  return {std::string(before), std::string(unit)};
}

}  // namespace wheelwright::import
