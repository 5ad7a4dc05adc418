#include "tools/wheelwright/import/formats/text/keyed_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"
#include "tools/wheelwright/import/formats/text/number_text.hpp"
#include "tools/wheelwright/import/formats/text/time_text.hpp"
#include "tools/wheelwright/import/formats/text/unit_text.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

using config::is_digit;

constexpr std::size_t max_words = 64;
constexpr std::size_t max_numbers = 512;

bool is_letter(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         character == '_' || static_cast<unsigned char>(character) >= 0x80;
}

bool begins_number(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (!text.empty() && text.front() == '.') text.remove_prefix(1);
  return !text.empty() && is_digit(text.front());
}

bool is_assigned(std::string_view rest) {
  rest = trim(rest);
  return rest.starts_with(':') || rest.starts_with('=');
}

// "[INFO] " of a ROS log.
void skip_log_level(std::string_view& line) {
  for (const std::string_view level : {"[DEBUG]", "[INFO]", "[WARN]", "[ERROR]", "[FATAL]"}) {
    if (!line.starts_with(level)) continue;
    line = trim(line.substr(level.size()));
    return;
  }
}

// A blank, then a number.
bool is_followed_by_number(std::string_view rest) {
  return !rest.empty() && (rest.front() == ' ' || rest.front() == '\t') && begins_number(trim(rest));
}

// "L12R-13", "A1B2C3": one letter and its whole number, again and again.
bool are_letters_with_numbers(std::string_view text) {
  std::size_t groups = 0;
  std::size_t at = 0;
  while (at < text.size() && is_letter(text[at]) && text[at] != '_') {
    ++at;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    if (at == text.size() || !is_digit(text[at])) return false;
    while (at < text.size() && is_digit(text[at])) ++at;
    ++groups;
  }
  return groups > 1 && !is_assigned(text.substr(at)) && !is_followed_by_number(text.substr(at));
}

}  // namespace

bool KeyedLine::parse(std::string_view line) {
  words_.clear();
  values_.clear();
  stamp_.reset();
  stamp_unit_ = {};
  take_stamp(line);
  while (!line.empty()) {
    if (words_.size() > max_words || values_.size() > max_numbers) return false;
    if (line.front() == '*') break;  // the checksum of an NMEA sentence
    if (begins_number(line)) {
      if (!take_number(line)) return false;
    } else if (is_letter(line.front())) {
      take_word(line);
    } else {
      line.remove_prefix(1);
    }
  }
  if (values_.empty() || words_.empty()) return false;
  lengthen_names();
  build_form();
  return true;
}

void KeyedLine::take_stamp(std::string_view& line) {
  line = trim(line);
  skip_log_level(line);
  auto prefix = stamp_prefix(line);
  if (!prefix) {
    const auto blank = std::min(line.find_first_of(" \t;"), line.size());
    const auto second = std::min(line.find_first_of(" \t;", blank + 1), line.size());
    const bool has_clock = read_time(line.substr(0, second), DateOrder::month_first).has_value();
    const auto length = has_clock ? second : blank;  // "2024-05-20 13:39:05.050"
    prefix = StampPrefix{line.substr(0, length), length};
  }
  if (const auto time = read_time(prefix->stamp, DateOrder::month_first)) {
    stamp_ = time->seconds;
    stamp_unit_ = time->form == TimeForm::clock ? "hms" : "iso";
    line.remove_prefix(prefix->length);
  }
}

// A number before all words is a time; two are a row of a table.
bool KeyedLine::take_number(std::string_view& rest) {
  double value = 0.0;
  const char* const begin = rest.data() + (rest.front() == '+' ? 1 : 0);
  const char* const end_of_rest = rest.data() + rest.size();
  const char* end = nullptr;
  if (rest.starts_with("0x") || rest.starts_with("0X")) {
    const auto length = std::min(rest.find_first_not_of("0123456789abcdefABCDEFxX"), rest.size());
    value = read_number(rest.substr(0, length), '.').value_or(nothing);
    end = begin + length;
  } else {
    // In "L12E13" the letter is the next key: an exponent without a point has a sign.
    const auto digits = std::min(
        rest.find_first_not_of("0123456789", static_cast<std::size_t>(begin - rest.data())), rest.size());
    const bool is_e = digits + 1 < rest.size() && (rest[digits] == 'E' || rest[digits] == 'e');
    // "R90E-12F3": every key of the line is a letter.
    const bool is_signed_key =
        is_e && digits + 2 < rest.size() && rest[digits + 1] == '-' && is_digit(rest[digits + 2]) &&
        !words_.empty() && words_.back().text.size() == 1 && are_letters_with_numbers(rest.substr(digits));
    const bool is_key = (is_e && is_digit(rest[digits + 1]) && !words_.empty()) || is_signed_key;
    const auto result = std::from_chars(begin, is_key ? rest.data() + digits : end_of_rest, value);
    if (result.ec == std::errc::invalid_argument) return false;
    if (result.ec != std::errc() || !std::isfinite(value)) value = nothing;
    end = result.ptr;
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (words_.empty()) {
    if (stamp_) return false;
    stamp_ = value;
    return true;
  }
  ++words_.back().numbers;
  values_.push_back(value);
  return true;
}

// "x1=5" and "M1 123" have the digit in the name, "L123" and "V0.5" have a number behind it.
std::size_t KeyedLine::word_length(std::string_view rest) const {
  std::size_t letters = 0;
  while (letters < rest.size() && is_letter(rest[letters])) ++letters;
  std::size_t all = letters;
  while (all < rest.size() && (is_letter(rest[all]) || is_digit(rest[all]) ||
                               (rest[all] == '.' && all + 1 < rest.size() && is_letter(rest[all + 1])) ||
                               (rest[all] == '/' && all + 1 < rest.size() && is_letter(rest[all + 1]))))
    ++all;
  if (letters == 1 && are_letters_with_numbers(rest)) return 1;
  const bool has_digits_only =
      all > letters && std::ranges::all_of(rest.substr(letters, all - letters), is_digit);
  if (!has_digits_only || is_assigned(rest.substr(all)) || is_followed_by_number(rest.substr(all)))
    return all;
  const bool has_decimals = all < rest.size() && rest[all] == '.';
  return letters == 1 || has_decimals ? letters : all;
}

void KeyedLine::take_word(std::string_view& rest) {
  const std::size_t length = word_length(rest);
  const std::string_view word = rest.substr(0, length);
  rest.remove_prefix(length);
  const bool has_key = !words_.empty();
  if (has_key && is_missing(word)) {
    ++words_.back().numbers;
    values_.push_back(nothing);
  } else if (const auto truth = read_number(word, '.'); has_key && truth) {
    ++words_.back().numbers;
    values_.push_back(*truth);
  } else if (has_key && words_.back().numbers > 0 && words_.back().unit.empty() && is_unit(word) &&
             !is_assigned(rest) && !begins_number(trim(rest))) {
    words_.back().unit = word;
  } else {
    words_.push_back({word, 0, {}});
  }
}

// "Left count: 1  Right count: 2" holds two names of two words, not one name twice.
void KeyedLine::lengthen_names() {
  const auto occurs_twice = [this](const KeyedWord& word) {
    return std::ranges::count_if(words_, [&word](const KeyedWord& other) {
             return other.numbers > 0 && other.text == word.text;
           }) > 1;
  };
  std::vector<std::size_t> to_join;
  for (std::size_t i = 1; i < words_.size(); ++i) {
    const KeyedWord& before = words_[i - 1];
    const char* const end = before.text.data() + before.text.size();
    const bool are_beside = words_[i].text.data() - end == 1 && before.numbers == 0;
    if (words_[i].numbers > 0 && are_beside && occurs_twice(words_[i])) to_join.push_back(i);
  }
  for (auto i = to_join.rbegin(); i != to_join.rend(); ++i) {
    const char* const begin = words_[*i - 1].text.data();
    const char* const end = words_[*i].text.data() + words_[*i].text.size();
    words_[*i].text = std::string_view(begin, static_cast<std::size_t>(end - begin));
    words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(*i) - 1);
  }
}

void KeyedLine::build_form() {
  form_ = stamp_ ? std::string("t") + std::string(stamp_unit_) : std::string();
  for (const KeyedWord& word : words_) {
    form_ += ' ';
    form_ += word.text;
    form_ += '/';
    form_ += std::to_string(word.numbers);
  }
}

}  // namespace wheelwright::import
