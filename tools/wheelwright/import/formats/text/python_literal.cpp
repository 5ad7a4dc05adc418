#include "tools/wheelwright/import/formats/text/python_literal.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "config/load/ascii_text.hpp"

namespace wheelwright::import {
namespace {

bool begins_word(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') || character == '_';
}

bool is_of_word(char character) {
  return begins_word(character) || config::is_digit(character) || character == '.';
}

class Translator {
 public:
  explicit Translator(std::string_view text) : text_(text) {}

  std::string run() {
    while (at_ < text_.size()) {
      const char character = text_[at_];
      if (character == '\'' || character == '"') {
        take_string(character);
      } else if (begins_word(character) || is_negative_word()) {
        take_word();
      } else {
        take_sign(character);
      }
    }
    return std::move(json_);
  }

 private:
  void take_string(char quote) {
    json_ += '"';
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      const bool is_escaped = text_[at_] == '\\' && at_ + 1 < text_.size();
      if (is_escaped) ++at_;
      if (is_escaped && text_[at_] != '\'') json_ += '\\';
      if (!is_escaped && text_[at_] == '"') json_ += '\\';
      json_ += text_[at_];
    }
    json_ += '"';
    ++at_;
  }

  // "-inf", "-nan".
  bool is_negative_word() const {
    return text_[at_] == '-' && at_ + 1 < text_.size() && begins_word(text_[at_ + 1]);
  }

  // A constant, or what stands before the brackets of a call: "np.float64(0.1)".
  void take_word() {
    if (text_[at_] == '-') ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_of_word(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (at_ < text_.size() && text_[at_] == '(') {
      are_calls_.push_back(true);
      ++at_;
    } else {
      json_ += constant(word);
    }
  }

  static std::string constant(std::string_view word) {
    std::string lower = config::lower_case(word);
    if (lower == "true" || lower == "false") return lower;
    const bool is_missing =
        lower == "none" || lower == "null" || lower == "nan" || lower == "inf" || lower == "infinity";
    return is_missing ? "null" : std::string(word);
  }

  void take_sign(char character) {
    ++at_;
    if (character == '(') {
      are_calls_.push_back(false);
      json_ += '[';
    } else if (character == ')' && !are_calls_.empty()) {
      if (!are_calls_.back()) close_tuple();
      are_calls_.pop_back();
    } else {
      json_ += character;
      // An exponent is no word.
      while (config::is_digit(character) && at_ < text_.size() &&
             (is_of_word(text_[at_]) || is_sign_of_exponent()))
        json_ += text_[at_++];
    }
  }

  bool is_sign_of_exponent() const {
    return (text_[at_] == '-' || text_[at_] == '+') && (json_.back() == 'e' || json_.back() == 'E');
  }

  // "(1,)".
  void close_tuple() {
    const auto last = json_.find_last_not_of(' ');
    if (last != std::string::npos && json_[last] == ',') json_.resize(last);
    json_ += ']';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string json_;
  std::vector<bool> are_calls_;  // of the brackets that are open
};

}  // namespace

std::string json_of_python(std::string_view text) {
  return Translator(text).run();
}

}  // namespace wheelwright::import
