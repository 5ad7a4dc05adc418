// Numbers as lines of a YAML mapping.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

// Begins the comments that a patch may replace.
inline constexpr std::string_view yaml_remark_mark = "# wheelwright:";

struct YamlLine {
  std::string key;  // with a dot before each level below
  std::string value;
  std::string remark;    // of the comment; may be empty
  bool is_flat = false;  // its dots are no levels
};

YamlLine yaml_line(const PlacedNumber& number);

// Each element of a number, as readers of YAML take it: with a point, since one without is an integer.
std::vector<std::string> yaml_values(const PlacedNumber& number);

// With the levels that their keys name; keys of one level stand together already.
std::string yaml_lines(const std::vector<YamlLine>& lines, const std::string& indent, const std::string& step,
                       const std::string& line_break);

}  // namespace wheelwright::tools
