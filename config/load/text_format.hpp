// Numbers as text, independent of locale, the same on every run.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace wheelwright::config {

// The shortest text that reads back as the same number.
inline std::string plain_number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

// With a fixed number of decimals; never "-0.000".
inline std::string fixed_number(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals)
          .ptr;
  std::string text(buffer.data(), end);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace wheelwright::config
