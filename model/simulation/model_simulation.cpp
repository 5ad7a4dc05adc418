#include "model/simulation/model_simulation.hpp"

#include <utility>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright {
namespace {

std::vector<std::unique_ptr<Effect>> made(std::span<const EffectSetting> settings) {
  std::vector<std::unique_ptr<Effect>> effects;
  for (const auto& setting : settings) effects.push_back(make_effect(setting));
  return effects;
}

}  // namespace

ModelSimulation::ModelSimulation(const LinearModel& core, std::span<const EffectSetting> effects)
    : ModelSimulation(core, made(effects)) {}

ModelSimulation::ModelSimulation(const LinearModel& core, std::vector<std::unique_ptr<Effect>> effects)
    : core_(core), effects_(std::move(effects)) {
  around_.period_s = core.period_s;
  around_.wheel_base_m = core.wheel_base_m;
  sort_by_hook();
  reset({});
}

ModelSimulation::ModelSimulation(const ModelSimulation& other)
    : core_(other.core_), around_(other.around_), motion_(other.motion_), with_place_(other.with_place_) {
  for (const auto& effect : other.effects_) effects_.push_back(effect->clone());
  sort_by_hook();
}

ModelSimulation& ModelSimulation::operator=(const ModelSimulation& other) {
  if (this == &other) return *this;
  if (effects_.size() != other.effects_.size()) return *this = ModelSimulation(other);
  core_ = other.core_;
  around_ = other.around_;
  motion_ = other.motion_;
  with_place_ = other.with_place_;
  for (std::size_t i = 0; i < effects_.size(); ++i) effects_[i]->assign(*other.effects_[i]);
  return *this;
}

void ModelSimulation::sort_by_hook() {
  for (const auto& effect : effects_) {
    const EffectHooks has = effect->hooks();
    if (has.command) with_hook_.command.push_back(effect.get());
    if (has.wheel) with_hook_.wheel.push_back(effect.get());
    if (has.floor) with_hook_.floor.push_back(effect.get());
    if (has.body) with_hook_.body.push_back(effect.get());
    if (has.observed) with_hook_.observed.push_back(effect.get());
  }
}

const ModelSimulation::Motion& ModelSimulation::step(const WheelPair& command_m_s, double battery_v) {
  around_.command_m_s = command_m_s;
  around_.battery_v = battery_v;
  WheelPair u = command_m_s;
  for (Effect* effect : with_hook_.command) effect->command(u, around_);
  WheelPair speed = core_.step(u);
  for (Effect* effect : with_hook_.wheel) effect->wheel(speed, around_);
  around_.next_speed_m_s = speed;
  motion_.wheel_m_s = speed;
  for (Effect* effect : with_hook_.floor) effect->floor(speed, around_);
  motion_.floor_m_s = speed;
  motion_.twist = twist_of_wheels(speed, around_.wheel_base_m);
  for (Effect* effect : with_hook_.body) effect->body(motion_.twist, around_);

  const double period_s = around_.period_s;
  if (with_place_) {
    around_.pose = move_along_arc(around_.pose, motion_.twist, period_s);
  } else {
    around_.pose.theta_rad += motion_.twist.w_rad_s * period_s;
  }
  around_.speed_m_s = motion_.wheel_m_s;
  around_.distance_m.left += motion_.wheel_m_s.left * period_s;
  around_.distance_m.right += motion_.wheel_m_s.right * period_s;
  around_.time_s += period_s;
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

void ModelSimulation::reset(const Pose& pose, const WheelPair& rolled_before_m) {
  core_.reset();
  for (const auto& effect : effects_) effect->reset();
  around_.time_s = 0.0;
  around_.command_m_s = around_.speed_m_s = around_.next_speed_m_s = {};
  around_.distance_m = rolled_before_m;
  around_.pose = pose;
  motion_ = {};
}

void ModelSimulation::take_over(const ModelSimulation& before) {
  around_.pose = before.around_.pose;
  around_.distance_m = before.around_.distance_m;
  around_.time_s = before.around_.time_s;
}

}  // namespace wheelwright
