#include "tests/benchmark/third_plant/motor.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

double Motor::force_n(double demand_m_s, double supply, double speed_m_s, double step_s) {
  constexpr double brush_m_s = 0.008;
  constexpr double diode_m_s = 0.01;
  held_back_ = false;
  const double voltage_v = bridge_v(curved_m_s(demand_m_s) * spec_.volts_per_m_s * supply);
  const double constant_n_a =
      spec_.constant_n_a * (1.0 - spec_.brush_advance * std::tanh(speed_m_s / brush_m_s));
  double resistance_ohm = spec_.resistance_ohm;
  if (current_a_ * speed_m_s < 0.0)
    resistance_ohm *= 1.0 + spec_.braking_resistance * std::min(1.0, std::abs(speed_m_s) / diode_m_s);

  // Implicit in the current: the electrical time constant is of the order of the step.
  const double inductance_h = spec_.resistance_ohm * spec_.electrical_time_s;
  current_a_ = (current_a_ + step_s / inductance_h * (voltage_v - constant_n_a * speed_m_s)) /
               (1.0 + step_s * resistance_ohm / inductance_h);
  limit_current(constant_n_a, speed_m_s);
  return constant_n_a * current_a_;
}

double Motor::curved_m_s(double demand_m_s) const {
  if (spec_.gain_at_rest == 0.0) return demand_m_s;
  const double share = std::min(1.3, std::abs(demand_m_s) / spec_.full_scale_m_s);
  return demand_m_s * (spec_.gain_at_rest - spec_.gain_drop * share);
}

double Motor::bridge_v(double wanted_v) {
  double given_v = wanted_v;
  if (spec_.clamp_v > 0.0) given_v = std::clamp(given_v, -spec_.clamp_v, spec_.clamp_v);
  held_back_ = given_v != wanted_v;
  constexpr double sharpness = 10.0;
  if (spec_.knee_v > 0.0)
    given_v /= std::pow(1.0 + std::pow(std::abs(given_v / spec_.knee_v), sharpness), 1.0 / sharpness);
  return given_v;
}

void Motor::limit_current(double constant_n_a, double speed_m_s) {
  if (spec_.force_limit_n == 0.0) return;
  const double max_a = (spec_.force_limit_n + std::abs(spec_.drag_n_s_m * speed_m_s)) / constant_n_a;
  if (std::abs(current_a_) <= max_a) return;
  current_a_ = std::copysign(max_a, current_a_);
  held_back_ = true;
}

}  // namespace plants::third
