#include "tools/wheelwright/export/model_text.hpp"

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "model/effect_library.hpp"

namespace wheelwright::tools {

std::string full_name(const EffectSetting& setting) {
  return setting.name + (setting.variant.empty() ? "" : " (" + setting.variant + ")");
}

std::string with_intervals(const AddedEffect& effect) {
  const auto parameters = parameters_of(effect.setting);
  std::string text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    text +=
        (i == 0 ? "" : ", ") + parameters[i].name + " " + config::plain_number(effect.setting.parameters[i]);
    if (parameters[i].unit != "1") text += " " + parameters[i].unit;
    if (i >= effect.intervals.size()) continue;
    text += " (95 % interval " + config::plain_number(effect.intervals[i].lower) + " to " +
            config::plain_number(effect.intervals[i].upper) + ")";
  }
  if (!effect.created.empty()) text += "; of " + config::printable(effect.created);
  return text;
}

std::string origin_of(const RobotModel& model) {
  return "robot " + (model.robot.empty() ? "without a name" : config::printable(model.robot)) +
         (model.created.empty() ? "" : ", model of " + config::printable(model.created));
}

}  // namespace wheelwright::tools
