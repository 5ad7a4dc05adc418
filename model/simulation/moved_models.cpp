#include "model/simulation/moved_models.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/effects/library/effect_library.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright {
namespace {

void scale(std::vector<double>& weights, double factor) {
  for (double& weight : weights) weight *= factor;
}

using Weights = std::vector<double> WheelResponse::*;

void add_gain_moves(const RobotModel& model, WheelResponse LinearModel::*wheel, const WheelFit& fit,
                    std::vector<MovedModels>& moved) {
  const auto add = [&](Weights weights, double gain, double standard_error) {
    if (gain == 0.0 || standard_error <= 0.0) return;
    const double relative = std::hypot(standard_error / gain, gain_discrepancy);
    MovedModels& both = moved.emplace_back(MovedModels{model, model});
    scale(both.up.linear_part.*wheel.*weights, 1.0 + relative);
    scale(both.down.linear_part.*wheel.*weights, 1.0 - relative);
  };
  const DcGain gain = dc_gain(model.linear_part.*wheel);
  add(&WheelResponse::from_left, gain.from_left, fit.gain_standard_error.from_left);
  add(&WheelResponse::from_right, gain.from_right, fit.gain_standard_error.from_right);
}

void scale_commands(LinearModel& model, double factor) {
  for (WheelResponse* wheel : {&model.left, &model.right}) {
    scale(wheel->from_left, factor);
    scale(wheel->from_right, factor);
  }
}

void add_scale_move(const RobotModel& model, std::vector<MovedModels>& moved) {
  if (!model.encoder_scale || model.encoder_scale->relative_standard_error <= 0.0) return;
  MovedModels& both = moved.emplace_back(MovedModels{model, model});
  scale_commands(both.up.linear_part, 1.0 + model.encoder_scale->relative_standard_error);
  scale_commands(both.down.linear_part, 1.0 - model.encoder_scale->relative_standard_error);
}

void add_effect_moves(const RobotModel& model, std::size_t index, double deviations,
                      std::vector<MovedModels>& moved) {
  const AddedEffect& effect = model.effects[index];
  const EffectInfo* info = find_effect(effect.setting.name);
  if (info == nullptr || info->wheel_mismatch) return;
  const auto& parameters = info->parameters_of(variant_index(*info, effect.setting.variant));
  for (std::size_t i = 0; i < effect.intervals.size(); ++i) {
    const double value = effect.setting.parameters[i];
    const auto towards = [&](double end) {
      return std::clamp(value + deviations * (end - value) / deviations_in_ci95, parameters[i].lower,
                        parameters[i].upper);
    };
    const double up = towards(effect.intervals[i].upper);
    const double down = towards(effect.intervals[i].lower);
    if (!std::isfinite(up) || !std::isfinite(down) || up == down) continue;
    MovedModels& both = moved.emplace_back(MovedModels{model, model});
    both.up.effects[index].setting.parameters[i] = up;
    both.down.effects[index].setting.parameters[i] = down;
  }
}

}  // namespace

std::vector<MovedModels> moved_models(const RobotModel& model) {
  std::vector<MovedModels> moved;
  if (model.left_fit) add_gain_moves(model, &LinearModel::left, *model.left_fit, moved);
  if (model.right_fit) add_gain_moves(model, &LinearModel::right, *model.right_fit, moved);
  add_scale_move(model, moved);
  for (MovedModels& effect : moved_effects(model, 1.0)) moved.push_back(std::move(effect));
  return moved;
}

std::vector<MovedModels> moved_effects(const RobotModel& model, double deviations) {
  std::vector<MovedModels> moved;
  for (std::size_t index = 0; index < model.effects.size(); ++index)
    add_effect_moves(model, index, deviations, moved);
  return moved;
}

}  // namespace wheelwright
