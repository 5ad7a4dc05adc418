// Changes of a text at known places, which leave every other byte as it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::tools {

class TextEdits {
 public:
  explicit TextEdits(std::string_view text) : text_(text) {}

  // Does nothing where the same stands there already. Ranges must not overlap.
  void replace(std::size_t offset, std::size_t length, std::string by);

  // Of several at one place the first comes first.
  void insert(std::size_t offset, std::string text) { replace(offset, 0, std::move(text)); }

  bool empty() const { return edits_.empty(); }
  std::string apply() const;

 private:
  struct Edit {
    std::size_t offset;
    std::size_t length;
    std::string by;
  };

  std::string_view text_;
  std::vector<Edit> edits_;
};

// Counted from 1.
std::size_t row_of(std::string_view text, std::size_t offset);

std::size_t line_begin(std::string_view text, std::size_t offset);
std::size_t line_end(std::string_view text, std::size_t offset);  // before its line break

// The blanks before `offset` where nothing else stands before it in its line.
std::optional<std::string> indent_at(std::string_view text, std::size_t offset);

// "\r\n" where the text's first line ends so.
std::string line_break_of(std::string_view text);

// Valid UTF-8 without a zero byte, which no text holds.
bool is_plain_utf8(std::string_view text);

// The first number or word from `offset` on that blanks end, within `length` bytes.
struct Token {
  std::size_t offset;
  std::size_t length;
};
std::vector<Token> tokens_of(std::string_view text, std::size_t offset, std::size_t length);

// A number of the same sign, nearer to zero.
bool is_tighter(std::string_view one, std::string_view than);

// The same number, as far as nine digits say, or the same word.
bool says_the_same(std::string_view one, std::string_view other);

}  // namespace wheelwright::tools
