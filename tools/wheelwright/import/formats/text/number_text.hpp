// A cell of a table as a number, in the ways that programs write one.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace wheelwright::import {

// A number and its unit in one cell, "0.05 sec", "12.4V": where the two are not parted by a blank the unit
// has two letters or more.
struct NumberWithUnit {
  double value = 0.0;
  std::string_view unit;
};
std::optional<NumberWithUnit> read_number_with_unit(std::string_view cell, char decimal);

// A number with the given sign before its decimals ('.' or ','); also 0x1F, true and false (1 and 0), and
// thousands separators where they can be nothing else (1,234.5 and 1,234,567, not 1,234 unless the digits of
// the file are `grouped`; 1'234 and 1 234, also with a blank that does not break). Nothing for infinity.
std::optional<double> read_number(std::string_view cell, char decimal, bool grouped = false);

// Whether a cell is a number of several groups of three digits by that separator ("1,234", "-12,345.6"), or
// has the separator and is not ("0,5", "12,34"), or has none.
enum class Grouping : std::uint8_t { none, grouped, other };
Grouping grouping_of(std::string_view cell, char decimal);

// Blank, or a word by which programs write that nothing stands there: nan, NULL, N/A, -, inf and their like.
bool is_missing(std::string_view cell);

}  // namespace wheelwright::import
