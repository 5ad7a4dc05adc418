#include "tests/benchmark/sixth_plant/camera.hpp"

#include <cmath>
#include <numbers>

#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

Mast::Mast(const Hidden& hidden) : natural_rad_s_(2 * std::numbers::pi * hidden.details.mast_hz()) {}

void Mast::sway(double& place_m, double& speed_m_s, double pushed_m_s2) const {
  constexpr double damping = 0.06;
  speed_m_s += fine_step_s * (-pushed_m_s2 - 2 * damping * natural_rad_s_ * speed_m_s -
                              natural_rad_s_ * natural_rad_s_ * place_m);
  place_m += fine_step_s * speed_m_s;
}

void Mast::step(double forward_m_s, double turn_rad_s) {
  sway(x_m_, x_m_s_, (forward_m_s - before_m_s_) / fine_step_s);
  sway(y_m_, y_m_s_, forward_m_s * turn_rad_s);
  before_m_s_ = forward_m_s;
}

void Camera::step(double forward_m_s, double turn_rad_s) {
  if (hidden_.has(Effect::mast_sway)) mast_.step(forward_m_s, turn_rad_s);
}

Pose Camera::look(const Pose& axle, Random& measuring) {
  constexpr double kept = 0.98;
  constexpr double fresh = 0.2;
  const double arm_m = hidden_[Effect::lever_arm];
  const double sway = hidden_[Effect::mast_sway];
  const double marker_x_m = arm_m * std::cos(hidden_.details.angle_rad) + sway * mast_.x_m();
  const double marker_y_m = arm_m * std::sin(hidden_.details.angle_rad) + sway * mast_.y_m();
  slow_.x_m = kept * slow_.x_m + fresh * noise_.seen_slow_m * bell(measuring);
  slow_.y_m = kept * slow_.y_m + fresh * noise_.seen_slow_m * bell(measuring);
  slow_.heading_rad = kept * slow_.heading_rad + fresh * noise_.seen_rad * 0.2 * bell(measuring);
  Pose seen = point_of_body(axle, marker_x_m, marker_y_m);
  seen.x_m += noise_.seen_m * bell(measuring);
  seen.x_m += slow_.x_m;
  seen.y_m += noise_.seen_m * bell(measuring);
  seen.y_m += slow_.y_m;
  seen.heading_rad += noise_.seen_rad * bell(measuring);
  seen.heading_rad += slow_.heading_rad;
  return seen;
}

}  // namespace plants::sixth
