// One line that names what it holds: its words, and the numbers behind each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::import {

struct KeyedWord {
  std::string_view text;
  std::size_t numbers = 0;  // that follow it
  std::string_view unit;    // behind the last of them
};

class KeyedLine {
 public:
  // False where the line has no word with a number behind it, or more than a line of that kind has.
  bool parse(std::string_view line);

  // The form of the line: equal for lines with the same words and as many numbers behind each.
  const std::string& form() const { return form_; }
  const std::vector<KeyedWord>& words() const { return words_; }
  const std::vector<double>& values() const { return values_; }
  const std::optional<double>& stamp() const { return stamp_; }  // before the first word
  std::string_view stamp_unit() const { return stamp_unit_; }    // "hms", "iso" or empty

 private:
  void take_stamp(std::string_view& line);
  bool take_number(std::string_view& rest);
  void take_word(std::string_view& rest);
  std::size_t word_length(std::string_view rest) const;
  void lengthen_names();
  void build_form();

  std::vector<KeyedWord> words_;
  std::vector<double> values_;
  std::optional<double> stamp_;
  std::string_view stamp_unit_;
  std::string form_;
};

}  // namespace wheelwright::import
