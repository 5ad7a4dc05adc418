#include "tests/benchmark/fifth_plant/surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

namespace {

constexpr double gravity_m_s2 = 9.81;

double against(double speed_m_s) {
  constexpr double plain_m_s = 0.01;
  return -std::tanh(speed_m_s / plain_m_s);
}

double patch_drag_n_s_m(const FloorSpec& floor, const Pose& contact) {
  double drag = 0.0;
  for (const Patch& patch : floor.patches) {
    const bool inside = contact.x_m > patch.from_x_m && contact.x_m < patch.to_x_m &&
                        contact.y_m > patch.from_y_m && contact.y_m < patch.to_y_m;
    if (inside) drag += patch.drag_n_s_m;
  }
  return drag;
}

double joint_n(const FloorSpec& floor, const Pose& contact) {
  if (floor.joint_every_m == 0.0) return 0.0;
  const double off = std::remainder(contact.x_m, floor.joint_every_m) / floor.joint_width_m;
  return floor.joint_n * std::exp(-off * off);
}

}  // namespace

Wrench operator+(const Wrench& one, const Wrench& other) {
  return {one.forward_n + other.forward_n, one.left_n + other.left_n, one.yaw_n_m + other.yaw_n_m};
}

Wrench floor_wrench(const Robot& robot, const BodyMotion& motion) {
  Wrench sum;
  const double weight_n = robot.mass_kg * gravity_m_s2 * robot.floor.slope_rad;
  sum.forward_n = -weight_n * std::cos(motion.pose.heading_rad - robot.floor.uphill_rad);
  sum.left_n = weight_n * std::sin(motion.pose.heading_rad - robot.floor.uphill_rad);
  if (robot.floor.patches.empty() && robot.floor.joint_every_m == 0.0) return sum;
  for (const double side : {1.0, -1.0}) {
    const double left_m = side * 0.5 * robot.wheel_base_m;
    const Pose contact = point_of_body(motion.pose, 0.0, left_m);
    const double speed_m_s = motion.forward_m_s - left_m * motion.turn_rad_s;
    const double force_n = joint_n(robot.floor, contact) * against(speed_m_s) -
                           patch_drag_n_s_m(robot.floor, contact) * speed_m_s;
    sum.forward_n += force_n;
    sum.yaw_n_m -= left_m * force_n;
  }
  return sum;
}

Wrench drag_wrench(const BodySpec& body, const BodyMotion& motion, bool driving, const Pose& anchor) {
  Wrench sum;
  const double turn = std::abs(motion.turn_rad_s);
  sum.forward_n = body.turn_drag_n_s * turn * against(motion.forward_m_s);
  sum.yaw_n_m = -body.scrub_n_m_s2 * turn * motion.turn_rad_s + (driving ? body.brush_n_m : 0.0);
  const double x_m = anchor.x_m - motion.pose.x_m;
  const double y_m = anchor.y_m - motion.pose.y_m;
  const double away_m = std::hypot(x_m, y_m);
  if (body.tether_n_m > 0.0 && away_m > body.tether_length_m) {
    const double pull_n = body.tether_n_m * (away_m - body.tether_length_m);
    const double cosine = std::cos(motion.pose.heading_rad);
    const double sine = std::sin(motion.pose.heading_rad);
    sum.forward_n += pull_n * (cosine * x_m + sine * y_m) / away_m;
    sum.left_n += pull_n * (cosine * y_m - sine * x_m) / away_m;
  }
  return sum;
}

Wrench Castor::step(const BodyMotion& motion) {
  if (body_.swivel_n_m == 0.0) return {};
  const double left_m_s = motion.left_m_s + motion.turn_rad_s * body_.swivel_x_m +
                          std::abs(motion.forward_m_s) * body_.swivel_lean;
  const double cosine = std::cos(swivel_rad_);
  const double sine = std::sin(swivel_rad_);
  const double swing_rad_s =
      (left_m_s * cosine - motion.forward_m_s * sine) / body_.swivel_trail_m - motion.turn_rad_s;
  swivel_rad_ += fine_step_s * swing_rad_s;
  constexpr double plain_rad_s = 0.5;
  const double torque_n_m = body_.swivel_n_m * std::tanh(swing_rad_s / plain_rad_s);
  const double sideways_n = -torque_n_m / body_.swivel_trail_m;
  return {-sine * sideways_n, cosine * sideways_n, body_.swivel_x_m * cosine * sideways_n + torque_n_m};
}

Wrench SlidingLoad::step(double forward_m_s) {
  if (body_.load_kg == 0.0) return {};
  constexpr double stop_n_m = 8000.0;
  constexpr double stop_n_s_m = 80.0;
  constexpr double plain_m_s = 0.005;
  const double sliding_m_s = speed_m_s_ - forward_m_s;
  double force_n = -body_.load_friction * body_.load_kg * gravity_m_s2 * std::tanh(sliding_m_s / plain_m_s);
  const double pressed_m = std::abs(place_m_) - body_.load_play_m;
  const double side = std::copysign(1.0, place_m_);
  // Stops push and never pull.
  if (pressed_m > 0.0)
    force_n -= side * std::max(0.0, stop_n_m * pressed_m + stop_n_s_m * side * sliding_m_s);
  speed_m_s_ += fine_step_s * force_n / body_.load_kg;
  place_m_ += fine_step_s * (speed_m_s_ - forward_m_s);
  return {-force_n, 0.0, 0.0};
}

Turret::Turret(const BodySpec& body, const Random& random) : body_(body), random_(random) {
  if (body_.turret_kg_m2 > 0.0) swing_from_s_ = random_.uniform(0.2, 1.0) * body_.turret_every_s;
}

Wrench Turret::step() {
  constexpr double half_swing_s = 0.35;
  constexpr double turning_rad_s2 = 12.0;
  time_s_ += fine_step_s;
  const double since_s = time_s_ - swing_from_s_;
  if (since_s < 0.0) return {};
  if (since_s > 2.0 * half_swing_s) {
    swing_from_s_ += body_.turret_every_s * random_.uniform(0.7, 1.3);
    side_ = -side_;
    return {};
  }
  const double faster = since_s < half_swing_s ? 1.0 : -1.0;
  return {0.0, 0.0, -body_.turret_kg_m2 * turning_rad_s2 * side_ * faster};
}

}  // namespace plants::fifth
