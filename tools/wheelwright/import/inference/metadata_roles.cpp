#include "tools/wheelwright/import/inference/metadata_roles.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace wheelwright::import {
namespace {

std::optional<double> number_between(const std::string& text, double minimum, double maximum) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= minimum) || value > maximum) {
    return std::nullopt;
  }
  return value;
}

constexpr double min_wheel_base_m = 0.001;
constexpr double max_wheel_base_m = 10.0;

std::string wheel_base_doubt(const Recording& recording, const std::string& text) {
  return recording.name + ": wheel_base_m: " + text + " is no wheel base in metres (0.001 to 10)" +
         (number_between(text, max_wheel_base_m, 1e4) ? "; is it in mm?" : "");
}

}  // namespace

void map_metadata(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& doubts) {
  for (const auto& recording : recordings) {
    for (const auto& [key, text] : recording.metadata) {
      if (key == "robot" && mapping.robot.empty()) mapping.robot = text;
      if (key == "wheel_base_m" && !mapping.wheel_base_m) {
        mapping.wheel_base_m = number_between(text, min_wheel_base_m, max_wheel_base_m);
        const std::string doubt = wheel_base_doubt(recording, text);
        if (!mapping.wheel_base_m && std::ranges::find(doubts, doubt) == doubts.end())
          doubts.push_back(doubt);
      }
      if (key == "period_s" && !mapping.time.period_s)
        mapping.time.period_s = number_between(text, 0.0001, 10.0);
      if (!mapping.wheels || !key.starts_with("metres_per_tick_")) continue;
      const auto scale = number_between(text, 1e-9, 1.0);
      if (key == "metres_per_tick_left" && !mapping.wheels->metres_per_count)
        mapping.wheels->metres_per_count = scale;
      if (key == "metres_per_tick_right" && scale != mapping.wheels->metres_per_count) {
        mapping.wheels->metres_per_count_right = scale;
      }
    }
  }
}

}  // namespace wheelwright::import
