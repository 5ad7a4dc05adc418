#include "model/simulation/robot_model.hpp"

namespace wheelwright {

std::vector<EffectSetting> effect_settings(const RobotModel& model) {
  std::vector<EffectSetting> settings;
  for (const auto& effect : model.effects) settings.push_back(effect.setting);
  return settings;
}

}  // namespace wheelwright
