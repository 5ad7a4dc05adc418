#include "tools/wheelwright/export/model_text.hpp"

#include <array>
#include <charconv>

#include "config/load/printable_text.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::tools {

std::string nine_digits(double value) {
  constexpr int digits = 9;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {buffer.data(), end};
}

std::string full_name(const EffectSetting& setting) {
  return setting.name + (setting.variant.empty() ? "" : " (" + setting.variant + ")");
}

std::string with_intervals(const AddedEffect& effect) {
  const auto parameters = parameters_of(effect.setting);
  std::string text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    text += (i == 0 ? "" : ", ") + parameters[i].name + " " + nine_digits(effect.setting.parameters[i]);
    if (parameters[i].unit != "1") text += " " + parameters[i].unit;
    if (i >= effect.intervals.size()) continue;
    text += " (95 % interval " + nine_digits(effect.intervals[i].lower) + " to " +
            nine_digits(effect.intervals[i].upper) + ")";
  }
  if (!effect.created.empty()) text += "; of " + config::printable(effect.created);
  return text;
}

std::string origin_of(const RobotModel& model) {
  return "robot " + (model.robot.empty() ? "without a name" : config::printable(model.robot)) +
         (model.created.empty() ? "" : ", model of " + config::printable(model.created));
}

}  // namespace wheelwright::tools
