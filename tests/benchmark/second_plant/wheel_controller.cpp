#include "tests/benchmark/second_plant/wheel_controller.hpp"

#include <cmath>

namespace plants::second {

double WheelController::voltage_v(double target_m_s, double measured_m_s, bool motor_limited, double step_s) {
  const double error_m_s = target_m_s - measured_m_s;
  // Anti-windup: a held-back motor would make the integrator run away.
  const bool would_wind_up = motor_limited && error_m_s * target_m_s > 0.0;
  if (!would_wind_up) integral_m_ += step_s * error_m_s;
  return spec_.feedforward_v_s_m * target_m_s + spec_.proportional_v_s_m * error_m_s +
         spec_.integral_v_m * integral_m_ + hunting_v(target_m_s, measured_m_s, step_s);
}

double WheelController::hunting_v(double target_m_s, double measured_m_s, double step_s) {
  if (spec_.hunting_v == 0.0 || target_m_s == 0.0) return 0.0;
  constexpr double kForgetting_s = 1.0;
  position_error_m_ += step_s * (target_m_s - measured_m_s - position_error_m_ / kForgetting_s);
  if (position_error_m_ > spec_.hunting_band_m) relay_ = 1.0;
  if (position_error_m_ < -spec_.hunting_band_m) relay_ = -1.0;
  return relay_ * spec_.hunting_v;
}

}  // namespace plants::second
