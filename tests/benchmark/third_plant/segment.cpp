#include "tests/benchmark/third_plant/segment.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

Segment motion(double duration_s, double forward_m_s, double turn_rad_s, const CommandLimits& limits) {
  const double half_m_s = 0.5 * turn_rad_s * limits.wheel_base_m;
  PerWheel<double> command_m_s{forward_m_s - half_m_s, forward_m_s + half_m_s};
  const double faster_m_s = std::max(std::abs(command_m_s[left_side]), std::abs(command_m_s[right_side]));
  for (double& speed_m_s : command_m_s) {
    if (faster_m_s > limits.fastest_m_s) speed_m_s *= limits.fastest_m_s / faster_m_s;
    if (!limits.reverses) speed_m_s = std::max(0.0, speed_m_s);
    if (speed_m_s != 0.0)
      speed_m_s = std::copysign(std::max(std::abs(speed_m_s), limits.slowest_m_s), speed_m_s);
  }
  return hold(duration_s, command_m_s);
}

Pose pose_after(const Segment& segment, const Pose& start, double wheel_base_m) {
  constexpr int parts = 20;
  const double part_s = segment.duration_s / parts;
  Pose pose = start;
  for (int part = 0; part < parts; ++part) {
    const PerWheel<double> command_m_s = segment.at((part + 0.5) / parts);
    const double travel_m = 0.5 * (command_m_s[left_side] + command_m_s[right_side]) * part_s;
    const double turn_rad = (command_m_s[right_side] - command_m_s[left_side]) / wheel_base_m * part_s;
    pose.x_m += travel_m * std::cos(pose.heading_rad + 0.5 * turn_rad);
    pose.y_m += travel_m * std::sin(pose.heading_rad + 0.5 * turn_rad);
    pose.heading_rad += turn_rad;
  }
  return pose;
}

}  // namespace plants::third
