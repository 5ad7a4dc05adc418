// Lines from the beginning, the middle and the end of a text, to decide from how it is to be read.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {

struct TextSample {
  std::vector<Line> head;                  // the first lines, numbered, comments among them
  std::vector<std::string_view> contents;  // lines from several places that are neither blank nor comments
};

TextSample take_sample(std::string_view text);

}  // namespace wheelwright::import
