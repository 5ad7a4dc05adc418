// The bytes of a text file as UTF-8, whichever encoding a program gave them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::import {

struct DecodedText {
  std::string text;                  // UTF-8, without a byte order mark
  std::string encoding;              // in words; empty for plain UTF-8 and ASCII
  std::vector<std::string> remarks;  // what was left out
};

// UTF-8 and UTF-16 (either byte order), each with or without a byte order mark; bytes that are not UTF-8 are
// taken for Latin-1. Colours of a terminal are left out. Zero bytes at the end, which a power cut leaves, are
// left out with a remark.
DecodedText decode_text(std::string bytes);

// Whether the first bytes of a file are text. A few stray bytes, as on a serial line, do no harm.
bool is_text(std::string_view head);

}  // namespace wheelwright::import
