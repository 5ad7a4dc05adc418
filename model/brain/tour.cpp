#include "model/brain/tour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace wheelwright {
namespace {

constexpr std::size_t legs_of_part = 2;
constexpr double speed_spread = 0.2;      // relative, either way
constexpr double shortest_leg = 0.8;      // in radii; two random points are 0.9 apart on average
constexpr double largest_distance = 0.9;  // of a point from the middle, in radii: curves lead beyond the legs
constexpr double largest_radius_m = 0.75;  // in larger circles legs stay as short, so that there are many

Checkpoint point_in_circle(const TourPlan& plan, PortableRandom& random) {
  const double angle = 2.0 * std::numbers::pi * random.uniform();
  const double distance_m = largest_distance * plan.radius_m * std::sqrt(random.uniform());
  return {plan.middle.x_m + distance_m * std::cos(angle), plan.middle.y_m + distance_m * std::sin(angle)};
}

Checkpoint next_point(const TourPlan& plan, const Checkpoint& at, PortableRandom& random) {
  for (;;) {
    const Checkpoint next = point_in_circle(plan, random);
    if (std::hypot(next.x_m - at.x_m, next.y_m - at.y_m) >= shortest_leg * plan.radius_m) return next;
  }
}

}  // namespace

Tour::Tour(TourPlan plan, const FollowerLimits& limits, PortableRandom& random) {
  plan.radius_m = std::min(plan.radius_m, largest_radius_m);
  Checkpoint at = plan.middle;
  for (double needed_s = 0.0; parts_.empty() || needed_s < plan.duration_s;) {
    Route part;
    part.speed_m_s = std::min(plan.speed_m_s * (1.0 + speed_spread * (2.0 * random.uniform() - 1.0)),
                              limits.largest_wheel_speed_m_s);
    for (std::size_t leg = 0; leg < legs_of_part; ++leg) {
      const Checkpoint next = next_point(plan, at, random);
      needed_s += std::hypot(next.x_m - at.x_m, next.y_m - at.y_m) / part.speed_m_s;
      part.checkpoints.push_back(next);
      at = next;
    }
    parts_.emplace_back(std::move(part), limits);
  }
}

void Tour::restart() {
  part_ = 0;
  begins_part_ = true;
}

WheelPair Tour::steer(const Pose& rest) {
  RouteFollower& part = parts_.at(part_);
  if (begins_part_) part.restart({rest.x_m, rest.y_m});
  begins_part_ = false;
  const WheelPair speed_m_s = part.steer(rest);
  if (part.finished()) {
    part_ = (part_ + 1) % parts_.size();
    begins_part_ = true;
  }
  return speed_m_s;
}

}  // namespace wheelwright
