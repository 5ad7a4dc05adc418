#include "model/simulation/model_simulation.hpp"

#include <algorithm>
#include <utility>

#include "model/effects/library/effect_library.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {
namespace {

std::vector<std::unique_ptr<Effect>> made(std::span<const EffectSetting> settings) {
  std::vector<EffectSetting> acting(settings.begin(), settings.end());
  std::stable_partition(acting.begin(), acting.end(), acts_first);
  std::vector<std::unique_ptr<Effect>> effects;
  effects.reserve(acting.size());
  for (const auto& setting : acting) effects.push_back(make_effect(setting));
  return effects;
}

}  // namespace

ModelSimulation::ModelSimulation(const RobotModel& model)
    : ModelSimulation(model.linear_part, effect_settings(model)) {}

ModelSimulation::ModelSimulation(const LinearModel& linear_part, std::span<const EffectSetting> effects)
    : ModelSimulation(linear_part, made(effects)) {}

ModelSimulation::ModelSimulation(const LinearModel& linear_part, std::vector<std::unique_ptr<Effect>> effects)
    : linear_part_(linear_part), effects_(std::move(effects)) {
  context_.period_s = linear_part.period_s;
  context_.wheel_base_m = linear_part.wheel_base_m;
  for (const auto& effect : effects_) {
    const WheelPair rolling = effect->rolling();
    context_.rolling.left *= rolling.left;
    context_.rolling.right *= rolling.right;
  }
  sort_by_hook();
  reset({});
}

ModelSimulation::ModelSimulation(const ModelSimulation& other)
    : linear_part_(other.linear_part_),
      context_(other.context_),
      motion_(other.motion_),
      with_place_(other.with_place_) {
  for (const auto& effect : other.effects_) effects_.push_back(effect->clone());
  sort_by_hook();
}

ModelSimulation& ModelSimulation::operator=(const ModelSimulation& other) {
  if (this == &other) return *this;
  if (effects_.size() != other.effects_.size()) return *this = ModelSimulation(other);
  linear_part_ = other.linear_part_;
  context_ = other.context_;
  motion_ = other.motion_;
  with_place_ = other.with_place_;
  for (std::size_t i = 0; i < effects_.size(); ++i) effects_[i]->assign(*other.effects_[i]);
  return *this;
}

void ModelSimulation::sort_by_hook() {
  for (const auto& effect : effects_) {
    const EffectHooks has = effect->hooks();
    if (has.command) with_hook_.command.push_back(effect.get());
    if (has.wheel) with_hook_.wheel.push_back({effect.get(), has.load});
    if (has.floor) with_hook_.floor.push_back(effect.get());
    if (has.body) with_hook_.body.push_back(effect.get());
    if (has.observed) with_hook_.observed.push_back(effect.get());
  }
}

const ModelSimulation::Motion& ModelSimulation::step(const WheelPair& command_m_s, double battery_v) {
  context_.command_m_s = command_m_s;
  context_.battery_v = battery_v;
  WheelPair u = command_m_s;
  for (Effect* effect : with_hook_.command) effect->command(u, context_);
  WheelPair speed = linear_part_.step(u);
  WheelPair load;
  for (const WheelEffect& each : with_hook_.wheel) {
    const WheelPair before = speed;
    each.effect->wheel(speed, context_);
    if (each.is_load) load = {load.left + before.left - speed.left, load.right + before.right - speed.right};
  }
  context_.load_m_s = load;
  context_.next_speed_m_s = speed;
  motion_.wheel_m_s = speed;
  for (Effect* effect : with_hook_.floor) effect->floor(speed, context_);
  motion_.floor_m_s = speed;
  motion_.twist = twist_of_wheels(speed, context_.wheel_base_m);
  for (Effect* effect : with_hook_.body) effect->body(motion_.twist, context_);

  const double period_s = context_.period_s;
  if (with_place_) {
    context_.pose = move_along_arc(context_.pose, motion_.twist, period_s);
  } else {
    context_.pose.theta_rad += motion_.twist.w_rad_s * period_s;
  }
  context_.speed_m_s = motion_.wheel_m_s;
  context_.distance_m.left += motion_.wheel_m_s.left * period_s;
  context_.distance_m.right += motion_.wheel_m_s.right * period_s;
  context_.time_s += period_s;
  return motion_;
}

Pose ModelSimulation::observed(const Pose& axle) const {
  Pose pose = axle;
  for (const Effect* effect : with_hook_.observed) pose = effect->observed(pose);
  return pose;
}

Pose ModelSimulation::axle_of(const Pose& point) const {
  const Pose offset = observed({0.0, 0.0, point.theta_rad});
  return {point.x_m - offset.x_m, point.y_m - offset.y_m, point.theta_rad};
}

void ModelSimulation::reset(const Pose& pose, const WheelPair& initial_travel_m) {
  linear_part_.reset();
  for (const auto& effect : effects_) effect->reset();
  context_.time_s = 0.0;
  context_.command_m_s = context_.speed_m_s = context_.next_speed_m_s = context_.load_m_s = {};
  context_.distance_m = initial_travel_m;
  context_.pose = pose;
  motion_ = {};
}

void ModelSimulation::take_over(const ModelSimulation& before) {
  context_.pose = before.context_.pose;
  context_.distance_m = before.context_.distance_m;
  context_.time_s = before.context_.time_s;
}

}  // namespace wheelwright
