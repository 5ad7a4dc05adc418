#include "model/brain/random_drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright {
namespace {

constexpr double rest_s = 0.7;  // at the end, so that the whole answer to the last command is recorded
constexpr int max_draws = 32;
constexpr int points_on_arc = 4;

int ticks_of(double seconds, double period_s) {
  return std::max(1, static_cast<int>(std::lround(seconds / period_s)));
}

}  // namespace

RandomDrive::RandomDrive(const RandomDrivePlan& plan, const RobotLimits& limits)
    : plan_(plan),
      period_s_(limits.period_s),
      wheel_base_m_(limits.wheel_base_m),
      largest_speed_m_s_(limits.largest_wheel_speed_m_s),
      drive_ticks_(ticks_of(plan.duration_s, limits.period_s)),
      rest_ticks_(ticks_of(rest_s, limits.period_s)),
      random_(plan.seed) {}

void RandomDrive::restart() {
  random_.seed(plan_.seed);
  tick_ = hold_ = 0;
  speed_m_s_ = {};
}

std::optional<WheelPair> RandomDrive::next(const Pose& rest) {
  ++tick_;
  if (tick_ > drive_ticks_) {
    // In steps that the motors can take.
    if (tick_ > drive_ticks_ + rest_ticks_) return std::nullopt;
    speed_m_s_ = within_limits({});
    return speed_m_s_;
  }
  const bool has_left = from_middle_m(rest) > plan_.radius_m && !stays_inside(rest, speed_m_s_);
  if (hold_ == 0 || has_left) draw(rest);
  --hold_;
  return speed_m_s_;
}

void RandomDrive::draw(const Pose& rest) {
  const int shortest = ticks_of(plan_.shortest_hold_s, period_s_);
  const int longest = std::max(shortest, ticks_of(plan_.longest_hold_s, period_s_));
  hold_ = shortest + static_cast<int>(uniform() * (longest - shortest + 1));
  for (int i = 0; i < max_draws; ++i) {
    const WheelPair drawn{plan_.spread_m_s * normal(), plan_.spread_m_s * normal()};
    for (const WheelPair& wanted : {drawn, WheelPair{-drawn.left, -drawn.right}}) {
      const WheelPair speed = within_limits(wanted);
      if (!stays_inside(rest, speed)) continue;
      speed_m_s_ = speed;
      return;
    }
  }
  // Nowhere to go from here at once: slow down and look again.
  speed_m_s_ = within_limits({});
  hold_ = 1;
}

WheelPair RandomDrive::within_limits(const WheelPair& wanted) const {
  const auto limited = [&](double speed, double now) {
    const double change = plan_.largest_change_m_s;
    return std::clamp(std::clamp(speed, -largest_speed_m_s_, largest_speed_m_s_), now - change, now + change);
  };
  return {limited(wanted.left, speed_m_s_.left), limited(wanted.right, speed_m_s_.right)};
}

double RandomDrive::from_middle_m(const Pose& pose) const {
  return std::hypot(pose.x_m - plan_.ahead_m, pose.y_m);
}

// Over the hold from now on. From outside the circle every way is good that leads no further out.
bool RandomDrive::stays_inside(const Pose& rest, const WheelPair& speed) const {
  const double allowed_m = std::max(plan_.radius_m, from_middle_m(rest));
  const Twist twist = twist_of_wheels(speed, wheel_base_m_);
  for (int i = 1; i <= points_on_arc; ++i) {
    const double duration_s = std::max(1, hold_) * period_s_ * i / points_on_arc;
    if (from_middle_m(move_along_arc(rest, twist, duration_s)) > allowed_m) return false;
  }
  return true;
}

// Uniform in [0, 1). The distributions of the standard library differ between platforms.
double RandomDrive::uniform() {
  return static_cast<double>(random_() >> 11U) * 0x1p-53;
}

// Standard normal (Box and Muller 1958).
double RandomDrive::normal() {
  const double size = std::sqrt(-2.0 * std::log1p(-uniform()));
  return size * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace wheelwright
