#include "tests/benchmark/second_plant/odd_command.hpp"

#include <cmath>
#include <utility>

namespace plants::second {

PerWheel<double> OddCommand::apply(PerWheel<double> command_m_s, double now_s) {
  command_m_s = resend(command_m_s, now_s);
  const double ratio = gear_ratio(command_m_s);
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    command_m_s[wheel] = ratio * remember(wheel, command_m_s[wheel]);
  return command_m_s;
}

PerWheel<double> OddCommand::resend(PerWheel<double> command_m_s, double now_s) {
  if (spec_.resend_jump_m_s <= 0.0) return command_m_s;
  double jump_m_s = 0.0;
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    jump_m_s = std::max(jump_m_s, std::abs(command_m_s[wheel] - newest_m_s_[wheel]));
  const PerWheel<double> previous_m_s = std::exchange(newest_m_s_, command_m_s);
  if (jump_m_s > spec_.resend_jump_m_s) {
    stale_m_s_ = previous_m_s;
    resend_from_s_ = now_s + spec_.resend_after_s;
  }
  const bool stale_now = now_s >= resend_from_s_ && now_s < resend_from_s_ + spec_.resend_hold_s;
  return stale_now ? stale_m_s_ : command_m_s;
}

double OddCommand::remember(std::size_t wheel, double command_m_s) {
  if (spec_.magnet_memory_m_s == 0.0) return command_m_s;
  constexpr double kSaturating_1_m_s = 25.0;
  const double change_m_s = command_m_s - last_input_m_s_[wheel];
  last_input_m_s_[wheel] = command_m_s;
  const double towards = change_m_s > 0.0 ? 1.0 : -1.0;
  double& state = magnetisation_[wheel];
  state = towards + (state - towards) * std::exp(-kSaturating_1_m_s * std::abs(change_m_s));
  return command_m_s - spec_.magnet_memory_m_s * state;
}

double OddCommand::gear_ratio(const PerWheel<double>& command_m_s) {
  const bool rest = command_m_s[left_side] == 0.0 && command_m_s[right_side] == 0.0;
  if (rest && !resting_) low_gear_ = !low_gear_;
  resting_ = rest;
  return low_gear_ ? spec_.low_gear_ratio : 1.0;
}

}  // namespace plants::second
