#include "tests/benchmark/sixth_plant/firmware.hpp"

#include <algorithm>
#include <cmath>

namespace plants::sixth {

void Firmware::doze(double time_s, const PerWheel<double>& command_m_s) {
  constexpr double falls_asleep_s = 0.6;
  constexpr double rest_m_s = 1e-4;
  if (std::abs(command_m_s[left_side]) < rest_m_s && std::abs(command_m_s[right_side]) < rest_m_s) {
    rested_s_ += fine_step_s;
    woken_s_ = -1;
    return;
  }
  if (rested_s_ > falls_asleep_s) woken_s_ = time_s;
  rested_s_ = 0;
}

// 0 = any.
double Firmware::steepest_m_s2(const PerWheel<double>& command_m_s) const {
  constexpr double differing_share = 0.15;
  const double between_m_s = std::abs(command_m_s[left_side] - command_m_s[right_side]);
  if (hidden_.has(Effect::turn_accel_clip) && between_m_s > differing_share * robot_.top_m_s)
    return robot_.top_m_s / hidden_[Effect::turn_accel_clip];
  return hidden_.has(Effect::rate_limit) ? robot_.top_m_s / hidden_[Effect::rate_limit] : 0;
}

double Firmware::smoothed(std::size_t side, double time_s, double wanted_m_s, double steepest_m_s2) {
  double wanted = wanted_m_s;
  if (hidden_.has(Effect::command_quantization)) {
    const double step_m_s = hidden_[Effect::command_quantization] * robot_.top_m_s;
    wanted = step_m_s * std::round(wanted / step_m_s);
  }
  double& ramped = ramped_m_s_[side];
  if (steepest_m_s2 > 0)
    ramped += std::clamp(wanted - ramped, -steepest_m_s2 * fine_step_s, steepest_m_s2 * fine_step_s);
  else
    ramped = wanted;
  const bool asleep =
      hidden_.has(Effect::driver_sleep) && woken_s_ >= 0 && time_s - woken_s_ < hidden_[Effect::driver_sleep];
  double& smooth = smoothed_m_s_[side];
  smooth += ((asleep ? 0 : ramped) - smooth) * fine_step_s / robot_.smoothing_s;
  return smooth;
}

double Firmware::through_bridge(std::size_t side, double duty_m_s) {
  const double top_m_s = robot_.top_m_s;
  double duty = duty_m_s;
  if (hidden_.has(Effect::dead_zone) && std::abs(duty) < hidden_[Effect::dead_zone] * top_m_s) duty = 0;
  if (hidden_.has(Effect::gain_curve)) {
    const double share = duty / top_m_s;
    duty *= 1 + hidden_[Effect::gain_curve] * hidden_.details.sign * (1 - 2 * std::abs(share)) * 0.8;
  }
  if (hidden_.has(Effect::saturation)) {
    const double most_m_s = (1 - hidden_[Effect::saturation]) * top_m_s;
    duty = std::clamp(duty, -most_m_s, most_m_s);
  }
  if (hidden_.has(Effect::gear_hysteresis)) {
    if (std::abs(duty) > 0.6 * top_m_s) weak_[side] = true;
    if (std::abs(duty) < 0.35 * top_m_s) weak_[side] = false;
    if (weak_[side]) duty *= 1 - hidden_[Effect::gear_hysteresis];
  }
  return duty;
}

PerWheel<double> Firmware::step(double time_s, const PerWheel<double>& command_m_s) {
  if (hidden_.has(Effect::driver_sleep)) doze(time_s, command_m_s);
  const double steepest = steepest_m_s2(command_m_s);
  PerWheel<double> duty_m_s{};
  for (const std::size_t side : {left_side, right_side})
    duty_m_s[side] = through_bridge(side, smoothed(side, time_s, command_m_s[side], steepest));
  return duty_m_s;
}

}  // namespace plants::sixth
