// Numbers as XML: attributes, and comments that say what is known of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

// A text that may stand in an XML comment.
std::string in_xml_comment(std::string text);

// The first comment of a fragment: its kind, the origin, and what is unsaid.
std::string xml_head(const std::string& kind, const RobotModel& model, const ModelNumbers& numbers);

// Marks the comments that a patch may replace.
inline constexpr std::string_view remark_mark = "wheelwright:";

// The comment on some numbers, in a line of its own; nothing where none has a remark.
std::string xml_remarks(const std::string& indent, const std::vector<PlacedNumber>& numbers);

// ` name="value"`.
std::string attribute_text(const std::string& name, const std::string& value);

}  // namespace wheelwright::tools
