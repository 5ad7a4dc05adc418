#include "model/motion_predictor.hpp"

#include <cmath>
#include <stdexcept>

namespace wheelwright {
namespace {

constexpr double standing_m_s = 1e-4;
constexpr int longest_coast_periods = 80;

}  // namespace

MotionPredictor::MotionPredictor(const LinearModel& model)
    : period_s_(model.period_s),
      wheel_base_m_(model.wheel_base_m),
      left_gain_(dc_gain(model.left)),
      right_gain_(dc_gain(model.right)),
      predictor_(model),
      scratch_(model) {
  const double determinant =
      left_gain_.from_left * right_gain_.from_right - left_gain_.from_right * right_gain_.from_left;
  if (!(std::abs(determinant) > 1e-6)) {
    throw std::invalid_argument("the model has no gain: no command makes both wheels move as wanted");
  }
}

WheelPair MotionPredictor::step(const WheelPair& command) {
  speed_ = predictor_.step(command);
  pose_ = move_along_arc(pose_, twist_of_wheels(speed_, wheel_base_m_), period_s_);
  return speed_;
}

Pose MotionPredictor::rest_pose() {
  scratch_ = predictor_;
  Pose pose = pose_;
  for (int k = 0; k < longest_coast_periods; ++k) {
    const WheelPair speed = scratch_.step({});
    pose = move_along_arc(pose, twist_of_wheels(speed, wheel_base_m_), period_s_);
    // The dead time passes before a command shows, so a slow start is no standstill.
    if (k > 8 && std::abs(speed.left) < standing_m_s && std::abs(speed.right) < standing_m_s) break;
  }
  return pose;
}

WheelPair MotionPredictor::command_for(const WheelPair& speed_m_s) const {
  const double determinant =
      left_gain_.from_left * right_gain_.from_right - left_gain_.from_right * right_gain_.from_left;
  return {(right_gain_.from_right * speed_m_s.left - left_gain_.from_right * speed_m_s.right) / determinant,
          (left_gain_.from_left * speed_m_s.right - right_gain_.from_left * speed_m_s.left) / determinant};
}

void MotionPredictor::reset(const Pose& pose) {
  predictor_.reset();
  speed_ = {};
  pose_ = pose;
}

}  // namespace wheelwright
