// Characters of ASCII, whatever the locale is.
#pragma once

#include <string>
#include <string_view>

namespace wheelwright::config {

constexpr bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

constexpr char to_lower(char character) {
  return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
}

inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& character : lower) character = to_lower(character);
  return lower;
}

// Without the blanks at both ends.
constexpr std::string_view trim(std::string_view text, std::string_view blanks = " \t\r\v\f") {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace wheelwright::config
