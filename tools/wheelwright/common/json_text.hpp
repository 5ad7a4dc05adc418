// JSON out to a file or a terminal, and in from a file of somebody else.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {

constexpr int max_json_levels = 64;

// Whatever bytes its strings hold; -1 indents nothing. Ends without a line break.
template <typename Json>
std::string json_text(const Json& json, int indent = 2) {
  return config::printable_json(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

// Null where the text is no JSON, or is nested deeper than any of this project.
inline nlohmann::json parse_json(const std::string& text) {
  bool too_deep = false;
  const auto watch = [&too_deep](int depth, nlohmann::json::parse_event_t, const nlohmann::json&) {
    too_deep = too_deep || depth > max_json_levels;
    return !too_deep;
  };
  auto json = nlohmann::json::parse(text, watch, false);
  return too_deep || json.is_discarded() ? nlohmann::json() : json;
}

// Throws UsageError where the file cannot be read; else as above.
inline nlohmann::json load_json(const std::filesystem::path& path) {
  return parse_json(config::read_text_or_throw<UsageError>(path, config::record_file));
}

}  // namespace wheelwright::tools
