#include "tests/benchmark/third_plant/firmware.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

PerWheel<double> Firmware::target_m_s(double now_s, double step_s) {
  for (; !on_the_way_.empty() && on_the_way_.front().due_s <= now_s; on_the_way_.pop_front())
    command_m_s_ = on_the_way_.front().command_m_s;
  PerWheel<double> target_m_s{};
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel) {
    const double kept_m_s = above_dead_band_m_s(whole_steps_m_s(command_m_s_[wheel]));
    target_m_s[wheel] = spec_.gain[wheel] * ramped_m_s(wheel, kept_m_s, step_s);
  }
  return target_m_s;
}

double Firmware::whole_steps_m_s(double command_m_s) const {
  if (spec_.command_step_m_s == 0.0) return command_m_s;
  const double steps = command_m_s / spec_.command_step_m_s;
  return spec_.command_step_m_s *
         (spec_.rounding == Rounding::nearest ? std::round(steps) : std::trunc(steps));
}

double Firmware::above_dead_band_m_s(double command_m_s) const {
  const double band_m_s = spec_.dead_band_m_s;
  if (band_m_s == 0.0) return command_m_s;
  if (std::abs(command_m_s) < band_m_s) return 0.0;
  if (!spec_.dead_band_rescales) return command_m_s;
  const double above_m_s = std::copysign(std::abs(command_m_s) - band_m_s, command_m_s);
  return above_m_s * spec_.full_scale_m_s / (spec_.full_scale_m_s - band_m_s);
}

double Firmware::ramped_m_s(std::size_t wheel, double command_m_s, double step_s) {
  if (spec_.ramp_m_s2 == 0.0) return command_m_s;
  const double max_m_s = spec_.ramp_m_s2 * step_s;
  ramp_m_s_[wheel] += std::clamp(command_m_s - ramp_m_s_[wheel], -max_m_s, max_m_s);
  return ramp_m_s_[wheel];
}

}  // namespace plants::third
