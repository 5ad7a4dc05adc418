// Numbers as text, independent of locale, the same on every run.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace wheelwright::config {

// The shortest text that reads back as the same number; never "-0".
inline std::string plain_number(double value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value).ptr;
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

// In double quotes, where YAML takes every text once these characters are escaped.
inline std::string quoted(const std::string& text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += {'\\', character};
    } else if (code < 0x20 || code == 0x7f) {
      result += {'\\', 'x', digits[code >> 4], digits[code & 15]};
    } else {
      result += character;
    }
  }
  return result + "\"";
}

}  // namespace wheelwright::config
