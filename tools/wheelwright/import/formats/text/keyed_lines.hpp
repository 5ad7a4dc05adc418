// Lines that name what they hold, as programs write them to a serial monitor: "M 123 456", "ODOM x y th",
// "L:123 R:456", "left=12, right=13", "E123,456", each perhaps behind a time ("12:34:56.789 -> ", an ISO
// time, or one number). Boot messages and other text may stand between them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/formats/text/text_sample.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// The share of the lines that have a form which comes again and begins with a word.
double share_of_keyed_lines(const TextSample& sample);

// Whether nearly all lines hold two words or more that are made equal to a number: "cmd_l=0.2 cmd_r=0.1".
bool are_assignments(const TextSample& sample);

// One stream for each form of line: words, and how many numbers stand behind each. Its channels have the
// words for names, or the place behind the word where several numbers follow it ("1", "2" where the line has
// one word; else "left.1"). Lines of another form, and forms that hardly occur, are left out with remarks.
std::vector<Stream> read_keyed_lines(std::string_view text, std::vector<std::string>& remarks);

}  // namespace wheelwright::import
