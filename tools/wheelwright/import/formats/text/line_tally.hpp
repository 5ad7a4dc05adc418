// Counts lines of a kind that a reader leaves out or mends, to say them in one remark.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {

class LineTally {
 public:
  void add(const Line& line) { add(line.number, line.text); }
  void add(std::size_t line_number, std::string_view text) {
    if (count_++ > 0) return;
    first_line_ = line_number;
    first_text_ = config::excerpt(trim(text));
  }
  std::size_t count() const { return count_; }

  // "line 12: WHAT ('text')", or "37 lines, the first is line 12: WHAT ('text')".
  void say(std::string_view what, std::vector<std::string>& remarks) const {
    if (count_ == 0) return;
    const std::string first = "line " + std::to_string(first_line_);
    const std::string lines = count_ == 1 ? first : std::to_string(count_) + " lines, the first is " + first;
    remarks.push_back(lines + ": " + std::string(what) + " ('" + first_text_ + "')");
  }

 private:
  std::size_t count_ = 0;
  std::size_t first_line_ = 0;
  std::string first_text_;
};

}  // namespace wheelwright::import
