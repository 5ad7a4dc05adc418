#include "model/uncertainty/moved_models.hpp"

#include <algorithm>
#include <cmath>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright {
namespace {

constexpr double deviations_in_ci95 = 1.96;
// A gain that was found at some speeds is off by so much at others: friction does not grow with speed.
constexpr double gain_off_at_other_speeds = 0.004;

void scale(std::vector<double>& weights, double factor) {
  for (double& weight : weights) weight *= factor;
}

// Adds `change` to the gain that these weights stand for.
void move_gain(std::vector<double>& weights, double gain, double change) {
  if (gain != 0.0) scale(weights, 1.0 + change / gain);
}

void add_gain_moves(const RobotModel& model, WheelResponse LinearModel::*wheel, const WheelFit& fit,
                    std::vector<RobotModel>& moved) {
  const DcGain gain = dc_gain(model.linear_part.*wheel);
  const double elsewhere = model.effects.empty() ? gain_off_at_other_speeds : 0.0;
  const auto add = [&](std::vector<double> WheelResponse::*weights, double value, double standard_error) {
    if (value == 0.0 || standard_error <= 0.0) return;
    move_gain(moved.emplace_back(model).linear_part.*wheel.*weights, value,
              std::hypot(standard_error, elsewhere * value));
  };
  add(&WheelResponse::from_left, gain.from_left, fit.gain_standard_error.from_left);
  add(&WheelResponse::from_right, gain.from_right, fit.gain_standard_error.from_right);
}

void add_scale_move(const RobotModel& model, std::vector<RobotModel>& moved) {
  if (!model.encoder_scale || model.encoder_scale->relative_standard_error <= 0.0) return;
  const double factor = 1.0 + model.encoder_scale->relative_standard_error;
  LinearModel& linear_part = moved.emplace_back(model).linear_part;
  for (WheelResponse* wheel : {&linear_part.left, &linear_part.right}) {
    scale(wheel->from_left, factor);
    scale(wheel->from_right, factor);
  }
}

void add_effect_moves(const RobotModel& model, std::size_t index, std::vector<RobotModel>& moved) {
  const AddedEffect& effect = model.effects[index];
  const EffectInfo* info = find_effect(effect.setting.name);
  if (info == nullptr) return;
  const auto& parameters = info->parameters_of(variant_index(*info, effect.setting.variant));
  for (std::size_t i = 0; i < effect.intervals.size(); ++i) {
    const double value = effect.setting.parameters[i];
    const ParameterInterval& interval = effect.intervals[i];
    const double up = interval.upper - value;
    const double down = interval.lower - value;
    const double change = (up >= -down ? up : down) / deviations_in_ci95;
    const double there = std::clamp(value + change, parameters[i].lower, parameters[i].upper);
    if (!std::isfinite(there) || there == value) continue;
    moved.emplace_back(model).effects[index].setting.parameters[i] = there;
  }
}

}  // namespace

std::vector<RobotModel> moved_models(const RobotModel& model) {
  std::vector<RobotModel> moved;
  if (model.left_fit) add_gain_moves(model, &LinearModel::left, *model.left_fit, moved);
  if (model.right_fit) add_gain_moves(model, &LinearModel::right, *model.right_fit, moved);
  add_scale_move(model, moved);
  for (std::size_t index = 0; index < model.effects.size(); ++index) add_effect_moves(model, index, moved);
  return moved;
}

}  // namespace wheelwright
