#include "tools/wheelwright/export/patch/text_edits.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "config/load/printable_text.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

void TextEdits::replace(std::size_t offset, std::size_t length, std::string by) {
  if (text_.substr(offset, length) != by) edits_.push_back({offset, length, std::move(by)});
}

std::string TextEdits::apply() const {
  std::vector<Edit> sorted = edits_;
  std::ranges::stable_sort(sorted, {}, &Edit::offset);
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : sorted) {
    result += text_.substr(at, edit.offset - at);
    result += edit.by;
    at = edit.offset + edit.length;
  }
  return result += text_.substr(at);
}

std::size_t row_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
}

std::size_t line_begin(std::string_view text, std::size_t offset) {
  if (offset == 0) return 0;
  const std::size_t before = text.rfind('\n', offset - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

std::size_t line_end(std::string_view text, std::size_t offset) {
  const std::size_t end = std::min(text.find('\n', offset), text.size());
  return end > offset && text[end - 1] == '\r' ? end - 1 : end;
}

std::optional<std::string> indent_at(std::string_view text, std::size_t offset) {
  const std::size_t begin = line_begin(text, offset);
  const std::string_view before = text.substr(begin, offset - begin);
  if (before.find_first_not_of(" \t") != std::string_view::npos) return std::nullopt;
  return std::string(before);
}

std::string line_break_of(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

bool is_plain_utf8(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) return false;
  return config::is_utf8(text);
}

std::vector<Token> tokens_of(std::string_view text, std::size_t offset, std::size_t length) {
  std::vector<Token> tokens;
  const std::size_t end = offset + length;
  while (true) {
    const std::size_t begin = text.find_first_not_of(blanks, offset);
    if (begin == std::string_view::npos || begin >= end) return tokens;
    offset = std::min(text.find_first_of(blanks, begin), end);
    tokens.push_back({begin, offset - begin});
  }
}

bool is_tighter(std::string_view one, std::string_view than) {
  const auto first = number_in(one);
  const auto second = number_in(than);
  return first && second && *first * *second > 0.0 && std::abs(*first) < std::abs(*second);
}

bool says_the_same(std::string_view one, std::string_view other) {
  if (one == other) return true;
  constexpr double nine_digits = 1e-8;
  const auto first = number_in(one);
  const auto second = number_in(other);
  if (!first || !second) return false;
  return std::abs(*first - *second) <= nine_digits * std::max(std::abs(*first), std::abs(*second));
}

}  // namespace wheelwright::tools
