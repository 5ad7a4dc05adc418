#include "model/simulation/motion_predictor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wheelwright {
namespace {

constexpr double standing_m_s = 1e-4;
constexpr double straight_rad_s = 1e-3;
constexpr int straight_periods = 16;  // longer than a command takes to show
constexpr int longest_coast_periods = 80;
// In these a command does not show, so that a slow start is no standstill.
constexpr int dead_periods = 8;

}  // namespace

MotionPredictor::MotionPredictor(const LinearModel& model)
    : MotionPredictor(model, std::span<const EffectSetting>{}) {}

MotionPredictor::MotionPredictor(const RobotModel& model)
    : MotionPredictor(model.linear_part, effect_settings(model)) {}

MotionPredictor::MotionPredictor(const LinearModel& linear_part, std::span<const EffectSetting> effects)
    : period_s_(linear_part.period_s),
      wheel_base_m_(linear_part.wheel_base_m),
      left_gain_(dc_gain(linear_part.left)),
      right_gain_(dc_gain(linear_part.right)),
      simulation_(linear_part, effects),
      scratch_(simulation_) {
  const double determinant =
      left_gain_.from_left * right_gain_.from_right - left_gain_.from_right * right_gain_.from_left;
  if (!(std::abs(determinant) > 1e-6)) {
    throw std::invalid_argument("the model has no gain: no command makes both wheels move as wanted");
  }
  if (!effects.empty()) settled_.emplace(linear_part, effects);
}

WheelPair MotionPredictor::step(const WheelPair& command) {
  return simulation_.step(command).wheel_m_s;
}

Pose MotionPredictor::rest_pose() {
  scratch_ = simulation_;
  for (int k = 0; k < longest_coast_periods; ++k) {
    const WheelPair& speed = scratch_.step({}).wheel_m_s;
    if (k > dead_periods && std::abs(speed.left) < standing_m_s && std::abs(speed.right) < standing_m_s)
      break;
  }
  Pose rest = scratch_.pose();
  if (settled_ && settled_->limits().straightening_periods > 0)
    rest.theta_rad = straightened_heading_rad(rest);
  return rest;
}

double MotionPredictor::straightened_heading_rad(const Pose& rest) {
  const WheelPair& speed = simulation_.motion().wheel_m_s;
  if (std::min(speed.left, speed.right) <= 0.0) return rest.theta_rad;
  const double ahead_m_s = simulation_.motion().twist.v_m_s;
  const WheelPair straight = settled_->command_for({ahead_m_s, ahead_m_s});
  scratch_ = simulation_;
  int straight_for = 0;  // periods: a turn that changes its direction is straight for a moment
  for (int k = 0; k < settled_->limits().straightening_periods && straight_for < straight_periods; ++k) {
    const double turn_rad_s = scratch_.step(straight).twist.w_rad_s;
    straight_for = std::abs(turn_rad_s) < straight_rad_s ? straight_for + 1 : 0;
  }
  return scratch_.pose().theta_rad;
}

WheelPair MotionPredictor::command_for(const WheelPair& speed_m_s) const {
  if (settled_) return settled_->command_for(speed_m_s);
  const double determinant =
      left_gain_.from_left * right_gain_.from_right - left_gain_.from_right * right_gain_.from_left;
  return {(right_gain_.from_right * speed_m_s.left - left_gain_.from_right * speed_m_s.right) / determinant,
          (left_gain_.from_left * speed_m_s.right - right_gain_.from_left * speed_m_s.left) / determinant};
}

void MotionPredictor::reset(const Pose& pose) {
  simulation_.reset(pose);
}

}  // namespace wheelwright
