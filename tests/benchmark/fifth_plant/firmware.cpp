#include "tests/benchmark/fifth_plant/firmware.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

Firmware::Firmware(const FirmwareSpec& spec, double wheel_base_m, const Random& random)
    : spec_(spec), wheel_base_m_(wheel_base_m), random_(random), link_(spec.delay_s, {}) {
  if (spec_.stall_every_s > 0.0) stall_from_s_ = random_.uniform(0.5, 1.0) * spec_.stall_every_s;
}

// While the link stands still the last command that came goes on.
PerWheel<double> Firmware::through_radio(const PerWheel<double>& command_m_s) {
  if (time_s_ > stall_from_s_ + spec_.stall_s)
    stall_from_s_ += spec_.stall_every_s * random_.uniform(0.8, 1.2);
  if (time_s_ < stall_from_s_) held_m_s_ = command_m_s;
  return link_.step(held_m_s_);
}

double Firmware::understood_m_s(double command_m_s) const {
  double size_m_s = std::abs(command_m_s);
  if (size_m_s < spec_.threshold_m_s) return 0.0;
  if (spec_.step_m_s > 0.0) size_m_s = spec_.step_m_s * std::round(size_m_s / spec_.step_m_s);
  return std::copysign(size_m_s, command_m_s);
}

// What the right wheel is given on top, and the left wheel less.
double Firmware::steering_m_s() const {
  if (!driving_) return 0.0;
  const double swing = std::fmod(time_s_, spec_.hunting_period_s) < 0.5 * spec_.hunting_period_s ? 1.0 : -1.0;
  return 0.5 * spec_.trim_rad_s * wheel_base_m_ + spec_.hunting_m_s * swing;
}

void Firmware::approach(double& wanted_m_s, double target_m_s) const {
  const bool falls = std::abs(target_m_s) < std::abs(wanted_m_s);
  const double smoothing_s = falls ? spec_.smoothing_down_s : spec_.smoothing_s;
  wanted_m_s += (target_m_s - wanted_m_s) * fine_step_s / smoothing_s;
}

PerWheel<double> Firmware::step(const PerWheel<double>& command_m_s) {
  constexpr double standing_m_s = 0.005;
  PerWheel<double> target_m_s = through_radio(command_m_s);
  driving_ = std::abs(target_m_s[left_side]) + std::abs(target_m_s[right_side]) > standing_m_s;
  const double steering = steering_m_s();
  const double max_m_s = spec_.ramp_m_s2 * fine_step_s;
  for (const std::size_t wheel : {left_side, right_side}) {
    double target = understood_m_s(target_m_s[wheel]) + (wheel == right_side ? steering : -steering);
    target = std::clamp(target, -spec_.fastest_m_s, spec_.fastest_m_s);
    ramped_m_s_[wheel] += std::clamp(target - ramped_m_s_[wheel], -max_m_s, max_m_s);
    approach(smooth_m_s_[wheel], ramped_m_s_[wheel]);
  }
  time_s_ += fine_step_s;
  return smooth_m_s_;
}

}  // namespace plants::fifth
