#include "model/brain/mission.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {

std::string_view name_of(PoseSource source) {
  switch (source) {
    case PoseSource::fir:
      return "fir";
    case PoseSource::arma:
      return "arma";
    case PoseSource::hybrid:
      return "hybrid";
    case PoseSource::odometry:
      return "odometry";
  }
  return "unknown";
}

FollowerLimits follower_limits(const RobotLimits& limits) {
  FollowerLimits result;
  result.period_s = limits.period_s;
  result.wheel_base_m = limits.wheel_base_m;
  result.largest_wheel_speed_m_s = limits.largest_wheel_speed_m_s;
  result.slowest_wheel_speed_m_s = limits.slowest_wheel_speed_m_s;
  result.acceleration_m_s2 = limits.acceleration_m_s2;
  return result;
}

WheelPair rounded_command(const WheelPair& command_m_s, const RobotLimits& limits) {
  const double step = limits.command_step_m_s;
  const double limit = limits.largest_wheel_speed_m_s;
  const auto round = [&](double speed) { return step * std::round(std::clamp(speed, -limit, limit) / step); };
  return {round(command_m_s.left), round(command_m_s.right)};
}

}  // namespace wheelwright
