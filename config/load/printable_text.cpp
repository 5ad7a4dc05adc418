#include "config/load/printable_text.hpp"

#include <array>
#include <cstdint>

namespace wheelwright::config {
namespace {

constexpr std::string_view digits = "0123456789abcdef";
constexpr std::size_t longest_excerpt = 80;

struct Character {
  std::string_view bytes;
  char32_t code = 0;
  bool is_utf8 = true;
};

// The length of the UTF-8 sequence that a byte begins; 0 where it begins none.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

bool is_a_character(char32_t code, std::size_t length) {
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
  return code >= smallest.at(length) && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
}

// Takes the first character off a text that is not empty, or its first byte where that begins none.
Character take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = sequence_length(first);
  Character character{text.substr(0, 1), first, length == 1};
  if (length > 1 && length <= text.size()) {
    char32_t code = first & (0xffU >> (length + 1));
    bool is_utf8 = true;
    for (const char next : text.substr(1, length - 1)) {
      const auto byte = static_cast<unsigned char>(next);
      is_utf8 = is_utf8 && (byte & 0xc0U) == 0x80U;
      code = (code << 6U) | (byte & 0x3fU);
    }
    if (is_utf8 && is_a_character(code, length)) character = {text.substr(0, length), code, true};
  }
  text.remove_prefix(character.bytes.size());
  return character;
}

bool is_between(char32_t code, char32_t first, char32_t last) {
  return code >= first && code <= last;
}

bool is_control(char32_t code) {
  return code < 0x20 || is_between(code, 0x7f, 0x9f);
}

// What changes the order of the characters around it, or ends a line.
bool changes_layout(char32_t code) {
  return code == 0x61c || is_between(code, 0x200e, 0x200f) || is_between(code, 0x2028, 0x202e) ||
         is_between(code, 0x2066, 0x2069) || code == 0xfeff;
}

bool is_harmless(const Character& character) {
  return character.is_utf8 && !is_control(character.code) && !changes_layout(character.code);
}

bool is_break_or_tabulator(const Character& character) {
  return character.code == '\n' || character.code == '\t';
}

std::string with_digits(std::string_view prefix, char32_t code, int count) {
  std::string text(prefix);
  for (int shift = 4 * (count - 1); shift >= 0; shift -= 4) text += digits[(code >> shift) & 15U];
  return text;
}

std::string escape(const Character& character) {
  return character.code < 0x80 || !character.is_utf8 ? with_digits("\\x", character.code, 2)
                                                     : with_digits("\\u", character.code, 4);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  while (!text.empty()) {
    const Character character = take_character(text);
    const std::string shown = is_harmless(character) ? std::string(character.bytes) : escape(character);
    if (result.size() + shown.size() > longest) return result + "...";
    result += shown;
  }
  return result;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = take_character(text);
    if (is_harmless(character) || is_break_or_tabulator(character)) {
      result += character.bytes;
    } else {
      result += escape(character);
    }
  }
  return result;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    if (!take_character(text).is_utf8) return false;
  }
  return true;
}

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const Character character = take_character(text);
  return character.is_utf8 ? character.bytes.size() : 0;
}

std::string excerpt(std::string_view text) {
  return printable(text, longest_excerpt);
}

std::string printable_json(std::string_view json) {
  std::string result;
  result.reserve(json.size());
  while (!json.empty()) {
    const Character character = take_character(json);
    if (is_harmless(character) || is_break_or_tabulator(character)) {
      result += character.bytes;
    } else {
      result += with_digits("\\u", character.is_utf8 ? character.code : 0xfffd, 4);
    }
  }
  return result;
}

}  // namespace wheelwright::config
