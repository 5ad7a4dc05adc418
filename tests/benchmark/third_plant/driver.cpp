#include "tests/benchmark/third_plant/driver.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

Driver::Driver(Style style, const DriveHabits& habits, const CommandLimits& limits, double run_s,
               Random random)
    : style_(style),
      turns_(limits.turns),
      run_s_(run_s),
      hand_s_(random.uniform(0.2, 0.45)),
      planner_(style, habits, limits, random) {}

PerWheel<double> Driver::command_m_s(double now_s, double period_s, const Pose& seen) {
  PerWheel<double> command_m_s{};
  if (!resting(now_s)) command_m_s = planned_m_s(now_s, seen);
  if (style_ == Style::joystick) command_m_s = smoothed_m_s(command_m_s, period_s);
  if (!turns_) command_m_s[right_side] = command_m_s[left_side];
  constexpr double wire_1_m_s = 1.0e4;
  for (double& speed_m_s : command_m_s) speed_m_s = std::round(speed_m_s * wire_1_m_s) / wire_1_m_s;
  return command_m_s;
}

bool Driver::resting(double now_s) const {
  constexpr double before_s = 0.6;
  constexpr double after_s = 1.0;
  return style_ != Style::one_speed && (now_s < before_s || now_s > run_s_ - after_s);
}

PerWheel<double> Driver::planned_m_s(double now_s, const Pose& seen) {
  while (!plan_.empty() && now_s - segment_from_s_ >= plan_.front().duration_s) {
    segment_from_s_ += plan_.front().duration_s;
    plan_.pop_front();
  }
  if (plan_.empty()) {
    const std::vector<Segment> next = planner_.next(now_s, seen);
    plan_.assign(next.begin(), next.end());
    segment_from_s_ = now_s;
  }
  return plan_.front().at((now_s - segment_from_s_) / plan_.front().duration_s);
}

PerWheel<double> Driver::smoothed_m_s(const PerWheel<double>& wanted_m_s, double period_s) {
  constexpr double let_go_m_s = 0.004;
  const double share = period_s / (hand_s_ + period_s);
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    hand_m_s_[wheel] += share * (wanted_m_s[wheel] - hand_m_s_[wheel]);
  const bool rest = wanted_m_s[left_side] == 0.0 && wanted_m_s[right_side] == 0.0;
  if (rest && std::abs(hand_m_s_[left_side]) + std::abs(hand_m_s_[right_side]) < let_go_m_s) hand_m_s_ = {};
  return hand_m_s_;
}

}  // namespace plants::third
