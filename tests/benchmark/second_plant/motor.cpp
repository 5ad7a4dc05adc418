#include "tests/benchmark/second_plant/motor.hpp"

#include <algorithm>
#include <cmath>

namespace plants::second {

double Motor::bridge_v(double demanded_v) const {
  const double available_v = spec_.supply_v - spec_.supply_resistance_ohm * std::abs(current_a_);
  const double duty = std::clamp(demanded_v / spec_.supply_v, -1.0, 1.0);
  const double bent = duty * (1.0 + spec_.pwm_bend) / (1.0 + spec_.pwm_bend * std::abs(duty));
  return std::clamp(bent * spec_.supply_v, -available_v, available_v);
}

double Motor::force_n(double demanded_v, double speed_m_s, double step_s) {
  const double advance = spec_.brush_advance * std::tanh(speed_m_s / 0.01);
  const double emf_v_s_m = spec_.emf_v_s_m * (1.0 + advance);
  const bool braking = current_a_ * speed_m_s < 0.0;
  const double resistance_ohm = spec_.resistance_ohm * (braking ? 1.0 + spec_.braking_resistance : 1.0);
  const double voltage_v = bridge_v(demanded_v);

  // Implicit in the current: the electrical time constant is of the order of the step.
  const double ratio = step_s / spec_.inductance_h;
  const double free_a =
      (current_a_ + ratio * (voltage_v - emf_v_s_m * speed_m_s)) / (1.0 + ratio * resistance_ohm);
  current_a_ = std::clamp(free_a, -spec_.current_limit_a, spec_.current_limit_a);
  const bool out_of_voltage = std::abs(demanded_v) > std::abs(voltage_v) + 1.0e-9 && spec_.pwm_bend == 0.0;
  limited_ = current_a_ != free_a || out_of_voltage;
  return emf_v_s_m * current_a_;
}

}  // namespace plants::second
