#include "model/gap/conclusion/found_model.hpp"

#include <utility>

namespace wheelwright::gap {
namespace {

AddedEffect with_evidence(const Finding& found, const ModelOrigin& origin) {
  AddedEffect added;
  added.setting = found.setting;
  added.intervals = found.intervals;
  added.source = origin.logs;
  added.heldout_gain_nats = found.heldout_gain_nats;
  added.p_value = found.p_value;
  return added;
}

}  // namespace

RobotModel linear_model_of(const TrialModel& trial, const ModelOrigin& origin) {
  RobotModel model;
  if (origin.given != nullptr) {
    model.robot = origin.given->robot;
    model.encoder_scale = origin.given->encoder_scale;
  }
  model.source = origin.logs;
  model.linear_part = trial.linear();
  return model;
}

RobotModel whole_model_of(const TrialModel& trial, const ModelOrigin& origin) {
  RobotModel model = linear_model_of(trial, origin);
  for (const auto& setting : trial.settings()) model.effects.push_back({setting, {}, {}, {}, {}, {}});
  return model;
}

RobotModel found_model_of(const TrialModel& trial, std::span<const Finding> found,
                          const ModelOrigin& origin) {
  RobotModel model = linear_model_of(trial, origin);
  const auto add = [&](const std::string& name) {
    for (const auto& one : found) {
      if (one.setting.name == name) model.effects.push_back(with_evidence(one, origin));
    }
  };
  add(std::string(dropout_name));
  for (const auto& effect : trial.effects) add(effect.info->name);
  return model;
}

}  // namespace wheelwright::gap
