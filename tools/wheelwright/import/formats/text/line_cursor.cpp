#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

#include <algorithm>

namespace wheelwright::import {

bool LineCursor::next(Line& line) {
  if (offset_ >= text_.size()) return false;
  // A text without LF is searched for one only once.
  if (!feed_is_known_ || next_feed_ < offset_) {
    next_feed_ = std::min(text_.find('\n', offset_), text_.size());
    feed_is_known_ = true;
  }
  const std::string_view until_feed = text_.substr(offset_, next_feed_ - offset_);
  const std::size_t length = std::min(until_feed.find('\r'), until_feed.size());
  std::size_t end = offset_ + length;
  line = {text_.substr(offset_, length), ++number_, end == text_.size()};
  if (end < text_.size() && text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n') ++end;
  offset_ = std::min(end + 1, text_.size());
  return true;
}

bool LineCursor::next_filled(Line& line) {
  while (next(line)) {
    if (!trim(line.text).empty()) return true;
  }
  return false;
}

}  // namespace wheelwright::import
