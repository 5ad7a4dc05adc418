// Names that go into the head of a log, one line each.
#pragma once

#include <string>
#include <string_view>

#include "config/load/yaml_reader.hpp"

namespace wheelwright::config {

// True where a text holds a line break or another control character.
bool has_control_character(std::string_view text);

// A text of one line; fails at its place where it holds a control character.
std::string one_line_text(YamlReader& reader, std::string_view key);
std::string one_line_text(YamlReader& reader, std::string_view key, const std::string& default_value);

}  // namespace wheelwright::config
