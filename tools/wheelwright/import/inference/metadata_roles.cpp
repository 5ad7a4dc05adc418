#include "tools/wheelwright/import/inference/metadata_roles.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "config/load/text_format.hpp"

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

// What a key of the metadata may be, and the smaller unit that a larger number may be in.
struct StatedNumber {
  std::string_view key;
  double minimum;
  double maximum;
  std::string_view unit;
  std::string_view smaller_unit;
};

constexpr StatedNumber wheel_base{"wheel_base_m", 0.001, 10.0, "m", "mm"};
constexpr StatedNumber period{"period_s", 0.0001, 10.0, "s", "ms"};
constexpr StatedNumber left_scale{"metres_per_tick_left", 1e-9, 1.0, "m", "mm"};
constexpr StatedNumber right_scale{"metres_per_tick_right", 1e-9, 1.0, "m", "mm"};

std::string range_text(const StatedNumber& stated) {
  return "from " + config::plain_number(stated.minimum) + " to " + config::plain_number(stated.maximum) +
         " " + std::string(stated.unit);
}

class Metadata {
 public:
  Metadata(const Recording& recording, std::vector<std::string>& doubts)
      : recording_(recording), doubts_(doubts) {}

  // Nothing where the file does not state it; a doubt as well where it states what cannot be.
  std::optional<double> number(const StatedNumber& stated) const {
    const auto entry = std::ranges::find(recording_.metadata, stated.key,
                                         [](const auto& pair) { return std::string_view(pair.first); });
    if (entry == recording_.metadata.end()) return std::nullopt;
    const auto value = number_between(entry->second, stated.minimum, stated.maximum);
    if (!value) doubt(stated, entry->second);
    return value;
  }

 private:
  void doubt(const StatedNumber& stated, const std::string& text) const {
    constexpr double smaller_per_unit = 1000.0;
    const bool is_smaller =
        number_between(text, stated.maximum, smaller_per_unit * stated.maximum).has_value();
    const std::string line = recording_.name + ": " + std::string(stated.key) + ": " + text + " is not " +
                             range_text(stated) +
                             (is_smaller ? "; is it in " + std::string(stated.smaller_unit) + "?" : "");
    if (std::ranges::find(doubts_, line) == doubts_.end()) doubts_.push_back(line);
  }

  const Recording& recording_;
  std::vector<std::string>& doubts_;
};

}  // namespace

void map_metadata(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& doubts) {
  for (const auto& recording : recordings) {
    const Metadata metadata(recording, doubts);
    for (const auto& [key, text] : recording.metadata)
      if (key == "robot" && mapping.robot.empty()) mapping.robot = text;
    if (!mapping.wheel_base_m) mapping.wheel_base_m = metadata.number(wheel_base);
    if (!mapping.time.period_s) mapping.time.period_s = metadata.number(period);
    if (!mapping.wheels) continue;
    if (!mapping.wheels->metres_per_count) mapping.wheels->metres_per_count = metadata.number(left_scale);
    const auto right = metadata.number(right_scale);
    if (right && right != mapping.wheels->metres_per_count) mapping.wheels->metres_per_count_right = right;
  }
}

}  // namespace wheelwright::import
