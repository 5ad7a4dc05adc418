#include "tests/benchmark/second_plant/firmware.hpp"

#include <algorithm>
#include <cmath>

namespace plants::second {

PerWheel<double> Firmware::target_m_s(double now_s, double step_s) {
  while (!inbox_.empty() && inbox_.front().due_s <= now_s) {
    command_m_s_ = inbox_.front().command_m_s;
    inbox_.pop_front();
  }
  const PerWheel<double> command_m_s = odd_.apply(command_m_s_, now_s);
  const double largest_change_m_s = spec_.ramp_m_s2 * step_s;
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel) {
    const double wanted_m_s = shaped(command_m_s[wheel]);
    ramped_m_s_[wheel] +=
        std::clamp(wanted_m_s - ramped_m_s_[wheel], -largest_change_m_s, largest_change_m_s);
  }
  return ramped_m_s_;
}

double Firmware::shaped(double command_m_s) const {
  if (std::abs(command_m_s) < spec_.minimum_command_m_s) return 0.0;
  if (spec_.command_step_m_s <= 0.0) return command_m_s;
  return spec_.command_step_m_s * std::round(command_m_s / spec_.command_step_m_s);
}

}  // namespace plants::second
