#include "tests/benchmark/third_plant/undercarriage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::third {

BodyMotion Undercarriage::step(const PerWheel<double>& floor_m_s, double step_s) {
  const double forward_m_s = 0.5 * (floor_m_s[left_side] + floor_m_s[right_side]);
  const double turn_rad_s = (floor_m_s[right_side] - floor_m_s[left_side]) / spec_.track_m;
  BodyMotion body;
  body.forward_m_s = forward_m_s - creep_m_s(forward_m_s, turn_rad_s);
  body.turn_rad_s =
      scrubbed_rad_s(turn_rad_s) + brush_rad_s(floor_m_s) + caster_rad_s(body.forward_m_s, step_s);
  return body;
}

double Undercarriage::scrubbed_rad_s(double turn_rad_s) const {
  const double share = std::abs(turn_rad_s) / spec_.fastest_turn_rad_s;
  return turn_rad_s / (1.0 + spec_.scrub * (spec_.scrub_power == 1 ? share : share * share));
}

double Undercarriage::creep_m_s(double forward_m_s, double turn_rad_s) const {
  constexpr double max_of_speed = 0.6;
  constexpr double turning_over_m_s = 0.05;
  const double loss_m_s =
      std::min(spec_.turn_loss_m * std::abs(turn_rad_s), max_of_speed * std::abs(forward_m_s));
  return std::tanh(forward_m_s / turning_over_m_s) * loss_m_s;
}

double Undercarriage::brush_rad_s(const PerWheel<double>& floor_m_s) const {
  constexpr double moving_m_s = 0.02;
  const double speed_m_s = 0.5 * (std::abs(floor_m_s[left_side]) + std::abs(floor_m_s[right_side]));
  return spec_.side_brush_rad_s * speed_m_s * speed_m_s / (speed_m_s * speed_m_s + moving_m_s * moving_m_s);
}

double Undercarriage::caster_rad_s(double forward_m_s, double step_s) {
  if (spec_.caster_rad_m == 0.0) return 0.0;
  caster_rad_ -= std::sin(caster_rad_) * step_s * forward_m_s / spec_.caster_trail_m;
  caster_rad_ = std::clamp(caster_rad_, caster_rest_rad, std::numbers::pi - caster_rest_rad);
  const double across = std::max(0.0, std::sin(caster_rad_) - std::sin(caster_rest_rad));
  return spec_.caster_rad_m * forward_m_s * across * across;
}

}  // namespace plants::third
