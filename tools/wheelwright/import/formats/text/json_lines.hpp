// JSON lines: one object a line, with numbers. Objects within are flattened ("pose.x"), arrays too
// ("ranges[0]"). Objects with the same members make a stream.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/formats/text/text_sample.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

bool are_json_lines(const TextSample& sample);
std::vector<Stream> read_json_lines(std::string_view text, std::vector<std::string>& remarks);

}  // namespace wheelwright::import
