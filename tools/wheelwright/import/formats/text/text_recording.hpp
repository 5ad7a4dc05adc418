// Text files as recordings: tables in any dialect (CSV of any tool, TUM and EuRoC references, MRCLAM files,
// drive logs), lines that name what they hold (serial monitor), and JSON lines.
//
// How a file was read is said in Recording::format, what was left out or mended in Recording::remarks. A time
// that was written for people becomes seconds: unit "hms" since midnight, "iso" since 1970 (UTC where no zone
// stands there).
#pragma once

#include <string>
#include <string_view>

#include "tools/wheelwright/import/formats/text/text_encoding.hpp"  // is_text
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// `text`: the bytes of the file; `name` stands for it in messages.
ReadResult read_text_table(std::string text, std::string name);

}  // namespace wheelwright::import
