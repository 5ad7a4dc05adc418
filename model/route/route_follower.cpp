#include "model/route/route_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelwright {
namespace {

constexpr double sharp_corner_rad = 0.8;  // from here on the robot stops and turns in place
// The same, of a robot that turns on for a while when it is told to go straight: a model knows least of that.
constexpr double sharp_corner_of_late_turn_rad = 0.25;
constexpr double aligned_rad = 0.012;  // heading error at which a turn in place ends
constexpr double look_ahead_m = 0.12;  // on the leg, beyond the robot
constexpr double heading_gain_per_s = 3.0;
// With a dead band in turning: heading errors at which a correction begins and ends, and the least turn rate
// of one, in dead bands.
constexpr double correct_from_rad = 0.024;
constexpr double corrected_rad = 0.003;
constexpr double clear_of_band = 3.0;
constexpr double below_saturation =
    0.97;                                // of the speed that a wheel can reach: there it answers to commands
constexpr double stop_short_m = 0.0004;  // less than one tick at the slowest speed

double angle_of(const Checkpoint& from, const Checkpoint& to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}

}  // namespace

RouteFollower::RouteFollower(Route route, const FollowerLimits& limits)
    : route_(std::move(route)), limits_(limits) {
  restart();
}

void RouteFollower::restart(const Checkpoint& start) {
  state_ = route_.checkpoints.empty() ? State::finished : State::turning;
  visited_ = 0;
  leg_start_ = start;
  further_tries_ = 3;
  speed_now_ = 0.0;
  command_m_s_ = {};
  correcting_ = false;
}

bool RouteFollower::stops_at(std::size_t checkpoint, const DriveLimits& robot) const {
  if (checkpoint + 1 >= route_.checkpoints.size()) return true;
  const Checkpoint& before = checkpoint == 0 ? leg_start_ : route_.checkpoints[checkpoint - 1];
  const Checkpoint& at = route_.checkpoints[checkpoint];
  const double corner = wrap_angle(angle_of(at, route_.checkpoints[checkpoint + 1]) - angle_of(before, at));
  return std::abs(corner) >
         (robot.straightening_periods > 0 ? sharp_corner_of_late_turn_rad : sharp_corner_rad);
}

WheelPair RouteFollower::steer(const Pose& rest, const DriveLimits& robot) {
  command_m_s_ = next_command(rest, robot);
  return command_m_s_;
}

WheelPair RouteFollower::next_command(const Pose& rest, const DriveLimits& robot) {
  if (state_ == State::turning) return turn(rest, robot);
  if (state_ == State::driving) return drive(rest, robot);
  return {};
}

WheelPair RouteFollower::turn(const Pose& rest, const DriveLimits& robot) {
  const Checkpoint here{rest.x_m, rest.y_m};
  const double error = wrap_angle(angle_of(here, route_.checkpoints[visited_]) - rest.theta_rad);
  if (std::abs(error) < aligned_rad) {
    state_ = State::driving;
    speed_now_ = 0.0;
    return drive(rest, robot);
  }
  const double radius = 0.5 * limits_.wheel_base_m;
  const double braking = std::sqrt(2.0 * limits_.braking_m_s2 * std::abs(error) * radius);
  speed_now_ = std::min(speed_now_ + limits_.acceleration_m_s2 * limits_.period_s,
                        std::min({braking, route_.speed_m_s, fastest_m_s(robot)}));
  const double wheel = std::max(speed_now_, limits_.slowest_wheel_speed_m_s);
  return error > 0.0 ? WheelPair{-wheel, wheel} : WheelPair{wheel, -wheel};
}

WheelPair RouteFollower::drive(const Pose& rest, const DriveLimits& robot) {
  const Checkpoint& target = route_.checkpoints[visited_];
  const double direction = angle_of(leg_start_, target);
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  const double remaining = c * (target.x_m - rest.x_m) + s * (target.y_m - rest.y_m);
  const double beside = -s * (rest.x_m - target.x_m) + c * (rest.y_m - target.y_m);
  const bool stops = stops_at(visited_, robot);
  if (remaining <= (stops ? stop_short_m : 0.0)) {
    arrive(rest, robot);
    return stops ? WheelPair{} : next_command(rest, robot);
  }
  const double error = wrap_angle(direction - std::atan2(beside, look_ahead_m) - rest.theta_rad);
  double wanted = std::min(route_.speed_m_s, fastest_m_s(robot)) * std::max(0.2, std::cos(error));
  if (stops) wanted = std::min(wanted, std::sqrt(2.0 * limits_.braking_m_s2 * remaining));
  speed_now_ = std::min(speed_now_ + limits_.acceleration_m_s2 * limits_.period_s, wanted);
  speed_now_ = std::max(speed_now_, limits_.slowest_wheel_speed_m_s);
  return eased(limited(speed_now_, turn_rate_for(error, robot), fastest_m_s(robot)));
}

// Beyond a dead band in proportion would mean along its edge for most of the way, where a model knows least.
double RouteFollower::turn_rate_for(double error_rad, const DriveLimits& robot) {
  const double proportional = heading_gain_per_s * error_rad;
  if (robot.turn_dead_band_rad_s == 0.0) return proportional;
  correcting_ = std::abs(error_rad) > (correcting_ ? corrected_rad : correct_from_rad);
  if (!correcting_) return 0.0;
  return std::copysign(std::max(std::abs(proportional), clear_of_band * robot.turn_dead_band_rad_s),
                       error_rad);
}

void RouteFollower::arrive(const Pose& rest, const DriveLimits& robot) {
  const Checkpoint& target = route_.checkpoints[visited_];
  const bool last = visited_ + 1 == route_.checkpoints.size();
  const double missed_by = std::hypot(target.x_m - rest.x_m, target.y_m - rest.y_m);
  if (last && missed_by > route_.tolerance_m && further_tries_ > 0) {
    --further_tries_;
    leg_start_ = {rest.x_m, rest.y_m};
    state_ = State::turning;
    speed_now_ = 0.0;
    return;
  }
  if (stops_at(visited_, robot)) {
    state_ = last ? State::finished : State::turning;
    speed_now_ = 0.0;
  }
  leg_start_ = target;
  ++visited_;
}

double RouteFollower::fastest_m_s(const DriveLimits& robot) const {
  return std::max(limits_.slowest_wheel_speed_m_s,
                  std::min(limits_.largest_wheel_speed_m_s, below_saturation * robot.fastest_wheel_m_s));
}

// Keeps the curvature where a wheel would be too fast.
WheelPair RouteFollower::limited(double v_m_s, double w_rad_s, double largest_m_s) const {
  const WheelPair wheels = wheels_of_twist({v_m_s, w_rad_s}, limits_.wheel_base_m);
  const double fastest = std::max(std::abs(wheels.left), std::abs(wheels.right));
  const double scale = fastest > largest_m_s ? largest_m_s / fastest : 1.0;
  return {wheels.left * scale, wheels.right * scale};
}

WheelPair RouteFollower::eased(const WheelPair& wanted_m_s) const {
  const double step_m_s = limits_.largest_wheel_acceleration_m_s2 * limits_.period_s;
  const auto towards = [step_m_s](double now_m_s, double wheel_m_s) {
    return std::clamp(wheel_m_s, now_m_s - step_m_s, now_m_s + step_m_s);
  };
  return {towards(command_m_s_.left, wanted_m_s.left), towards(command_m_s_.right, wanted_m_s.right)};
}

}  // namespace wheelwright
