#include "model/brain/random_drive.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

constexpr double rest_s = 0.7;  // after a part, so that the whole answer to its last command is recorded
constexpr int max_draws = 32;
constexpr int points_on_arc = 4;

int nearest_ticks(double seconds, double period_s) {
  return std::max(1, static_cast<int>(std::lround(seconds / period_s)));
}

Tour tour_of(const RandomDrivePlan& plan, const RobotLimits& limits) {
  PortableRandom random(plan.seed);
  const TourPlan tour{
      {plan.ahead_m, 0.0}, plan.radius_m, plan.tour_speed_m_s, plan.tour_share * plan.duration_s};
  return {tour, follower_limits(limits), random};
}

}  // namespace

RandomDrive::RandomDrive(const RandomDrivePlan& plan, const RobotLimits& limits)
    : plan_(plan),
      period_s_(limits.period_s),
      wheel_base_m_(limits.wheel_base_m),
      largest_speed_m_s_(limits.largest_wheel_speed_m_s),
      rest_ticks_(nearest_ticks(rest_s, limits.period_s)),
      random_(plan.seed),
      tour_(tour_of(plan, limits)) {
  restart();
}

void RandomDrive::restart(bool has_model) {
  const double share = has_model ? plan_.tour_share : 0.0;
  random_ticks_ = nearest_ticks((1.0 - share) * plan_.duration_s, period_s_);
  tour_ticks_ = nearest_ticks(plan_.duration_s, period_s_) - random_ticks_;
  random_ = PortableRandom(plan_.seed);
  tour_.restart();
  tick_ = hold_ = 0;
  speed_m_s_ = {};
}

std::optional<WheelPair> RandomDrive::next(const Pose& rest) {
  const int tick = tick_++;
  const int tour_begins = random_ticks_ + rest_ticks_;
  const int tour_ends = tour_ticks_ > 0 ? tour_begins + tour_ticks_ : random_ticks_;
  if (tick < random_ticks_) {
    speed_m_s_ = random_speed(rest);
  } else if (tick >= tour_begins && tick < tour_ends) {
    speed_m_s_ = tour_.steer(rest);
  } else if (tick < tour_ends + rest_ticks_) {
    speed_m_s_ = within_limits({});  // in steps that the motors can take
  } else {
    return std::nullopt;
  }
  return speed_m_s_;
}

WheelPair RandomDrive::random_speed(const Pose& rest) {
  const bool has_left = from_middle_m(rest) > plan_.radius_m && !stays_inside(rest, speed_m_s_);
  if (hold_ == 0 || has_left) draw(rest);
  --hold_;
  return speed_m_s_;
}

void RandomDrive::draw(const Pose& rest) {
  const int shortest = nearest_ticks(plan_.shortest_hold_s, period_s_);
  const int longest = std::max(shortest, nearest_ticks(plan_.longest_hold_s, period_s_));
  hold_ = shortest + static_cast<int>(random_.uniform() * (longest - shortest + 1));
  for (int i = 0; i < max_draws; ++i) {
    const WheelPair drawn{plan_.spread_m_s * random_.normal(), plan_.spread_m_s * random_.normal()};
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

}  // namespace wheelwright
