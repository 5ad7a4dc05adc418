// The lines of a text, one after the other. A line ends at LF, CR or CR LF, also where a file mixes them.
#pragma once

#include <cstddef>
#include <string_view>

#include "config/load/ascii_text.hpp"

namespace wheelwright::import {

struct Line {
  std::string_view text;
  std::size_t number = 0;      // from 1
  bool is_open_ended = false;  // the last one, without a line break behind it
};

// Copied to look ahead; `text` has to outlive it.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : text_(text) {}

  // False at the end of the text.
  bool next(Line& line);
  // As next(), past lines without a character that shows.
  bool next_filled(Line& line);
  std::size_t offset() const { return offset_; }  // of the line that comes next

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
  std::size_t next_feed_ = 0;  // the first LF at or after offset_, once it was searched
  bool feed_is_known_ = false;
};

using config::trim;

}  // namespace wheelwright::import
