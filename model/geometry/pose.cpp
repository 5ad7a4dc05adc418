#include "model/geometry/pose.hpp"

#include <cmath>
#include <numbers>

namespace wheelwright {

double wrap_angle(double angle_rad) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double wrapped = std::remainder(angle_rad, turn);
  return wrapped <= -std::numbers::pi ? wrapped + turn : wrapped;
}

namespace {

// sin(x)/x; by its series where that is exact to the last digit and saves a sine in every sample.
double sine_over_angle(double x) {
  const double squared = x * x;
  if (squared > 0.0025) return std::sin(x) / x;
  return 1.0 - squared / 6.0 * (1.0 - squared / 20.0 * (1.0 - squared / 42.0));
}

}  // namespace

// A series, too, is exact to the last digit there.
Direction direction_of(double angle_rad) {
  const double squared = angle_rad * angle_rad;
  if (squared > 0.0025) return {std::cos(angle_rad), std::sin(angle_rad)};
  return {1.0 - squared / 2.0 * (1.0 - squared / 12.0 * (1.0 - squared / 30.0 * (1.0 - squared / 56.0))),
          angle_rad * (1.0 - squared / 6.0 * (1.0 - squared / 20.0 * (1.0 - squared / 42.0)))};
}

Pose move_along_arc(const Pose& pose, const Twist& twist, double duration_s) {
  const double turned = twist.w_rad_s * duration_s;
  const double half = 0.5 * turned;
  // The chord of an arc is its length times sin(half)/half, in the direction halfway through the turn.
  const double chord = twist.v_m_s * duration_s * sine_over_angle(half);
  const auto [cosine, sine] = direction_of(pose.theta_rad + half);
  return {pose.x_m + chord * cosine, pose.y_m + chord * sine, pose.theta_rad + turned};
}

Pose between(const Pose& origin, const Pose& pose) {
  const double dx = pose.x_m - origin.x_m;
  const double dy = pose.y_m - origin.y_m;
  const double c = std::cos(origin.theta_rad);
  const double s = std::sin(origin.theta_rad);
  return {c * dx + s * dy, -s * dx + c * dy, pose.theta_rad - origin.theta_rad};
}

Pose compose(const Pose& origin, const Pose& offset) {
  const double c = std::cos(origin.theta_rad);
  const double s = std::sin(origin.theta_rad);
  return {origin.x_m + c * offset.x_m - s * offset.y_m, origin.y_m + s * offset.x_m + c * offset.y_m,
          origin.theta_rad + offset.theta_rad};
}

double distance_between_m(const Pose& a, const Pose& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

}  // namespace wheelwright
