#include "drivers/simulation/chassis.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::simulation {
namespace {

constexpr double gravity_m_s2 = 9.81;
// Below this speed a drag fades out, so that it holds the body instead of shaking it.
constexpr double still_m_s = 0.002;
constexpr double still_rad_s = 0.02;
// Creep is slip per distance rolled; a wheel that hardly rolls still gives a little.
constexpr double min_rolling_m_s = 0.02;

}  // namespace

Chassis::Chassis(const ChassisConfig& config, const Pose& start)
    : config_(config),
      caster_(config.caster),
      pose_(start),
      cos_heading_(std::cos(start.theta_rad)),
      sin_heading_(std::sin(start.theta_rad)) {}

void Chassis::move(DriveUnit& left, DriveUnit& right, const Room& room, const WheelContact& contact,
                   double duration_s) {
  const double half_base_m = 0.5 * config_.wheel_base_m;
  const Surface& left_floor = room.surface(in_room(0.0, half_base_m));
  const Surface& right_floor = room.surface(in_room(0.0, -half_base_m));
  apply_body_forces(left_floor, right_floor, duration_s);
  stop_at_walls(room, duration_s);
  apply_traction(left, right, load(left, left_floor, contact.left), load(right, right_floor, contact.right),
                 duration_s);

  pose_ = pose_after(duration_s);
  cos_heading_ = std::cos(pose_.theta_rad);
  sin_heading_ = std::sin(pose_.theta_rad);
  left.turn(duration_s);
  right.turn(duration_s);
}

Chassis::WheelLoad Chassis::load(const DriveUnit& wheel, const Surface& surface, bool on_floor) const {
  if (!on_floor) return {0.0, 0.0};
  const double load_n = 0.5 * config_.load_on_drive_wheels * config_.mass_kg * gravity_m_s2;
  const double rolling_m_s = std::abs(wheel.speed_rad_s()) * wheel.rolling_radius_m();
  return {surface.grip > 0.0 ? surface.grip * load_n : -1.0,
          surface.creep_per_n * std::max(rolling_m_s, min_rolling_m_s)};
}

// Slope, carpet, scrubbing tyres and the caster. Drags are taken implicitly: they can stop the body but never
// turn it round.
void Chassis::apply_body_forces(const Surface& left, const Surface& right, double duration_s) {
  const double slope =
      0.5 * (cos_heading_ * (left.slope_x + right.slope_x) + sin_heading_ * (left.slope_y + right.slope_y));
  const Caster::Force caster = caster_.follow(forward_m_s_, turn_rad_s_, duration_s);
  forward_m_s_ += duration_s * (caster.forward_n / config_.mass_kg - gravity_m_s2 * slope);
  turn_rad_s_ += duration_s * caster.yaw_nm / config_.yaw_inertia_kg_m2;

  const double pile_m_s2 = 0.5 * (left.rolling_drag + right.rolling_drag) * gravity_m_s2;
  forward_m_s_ /= 1.0 + duration_s * pile_m_s2 / (std::abs(forward_m_s_) + still_m_s);
  const double scrub_rad_s2 =
      0.5 * (left.scrub_factor + right.scrub_factor) * config_.yaw_scrub_nm / config_.yaw_inertia_kg_m2;
  turn_rad_s_ /= 1.0 + duration_s * scrub_rad_s2 / (std::abs(turn_rad_s_) + still_rad_s);
}

// Finds the two traction forces that leave each tyre with just the slip that belongs to its force, both at
// once because the body couples the wheels, and lets a wheel slide where that force is more than the floor
// can give.
void Chassis::apply_traction(DriveUnit& left, DriveUnit& right, const WheelLoad& left_load,
                             const WheelLoad& right_load, double duration_s) {
  const double half_base_m = 0.5 * config_.wheel_base_m;
  const double left_radius_m = left.rolling_radius_m();
  const double right_radius_m = right.rolling_radius_m();
  const double by_pushing = 1.0 / config_.mass_kg;
  const double by_turning = half_base_m * half_base_m / config_.yaw_inertia_kg_m2;
  const double own = duration_s * (by_pushing + by_turning);
  const double cross = duration_s * (by_pushing - by_turning);
  const double left_own =
      own + duration_s * left_radius_m * left_radius_m * left.inverse_inertia() + left_load.creep_m_s_per_n;
  const double right_own = own + duration_s * right_radius_m * right_radius_m * right.inverse_inertia() +
                           right_load.creep_m_s_per_n;
  const double left_slip = left_radius_m * left.speed_rad_s() - left_speed_m_s();
  const double right_slip = right_radius_m * right.speed_rad_s() - right_speed_m_s();

  const auto limited = [](double force_n, const WheelLoad& wheel) {
    return wheel.limit_n < 0.0 ? force_n : std::clamp(force_n, -wheel.limit_n, wheel.limit_n);
  };
  const double determinant = left_own * right_own - cross * cross;
  const double left_free_n = (left_slip * right_own - cross * right_slip) / determinant;
  const double right_free_n = (right_slip * left_own - cross * left_slip) / determinant;
  double left_n = limited(left_free_n, left_load);
  double right_n = limited(right_free_n, right_load);
  if (left_n != left_free_n) right_n = limited((right_slip - cross * left_n) / right_own, right_load);
  if (right_n != right_free_n) left_n = limited((left_slip - cross * right_n) / left_own, left_load);

  left.push(left_n * left_radius_m, duration_s);
  right.push(right_n * right_radius_m, duration_s);
  forward_m_s_ += duration_s * (left_n + right_n) / config_.mass_kg;
  turn_rad_s_ += duration_s * (right_n - left_n) * half_base_m / config_.yaw_inertia_kg_m2;
}

// A wall takes away the speed into it and pushes the body out; along it the body slides.
void Chassis::stop_at_walls(const Room& room, double duration_s) {
  free_way_m_ -= std::abs(forward_m_s_) * duration_s;
  if (free_way_m_ > 0.0) return;
  const Nearest wall = room.nearest({pose_.x_m, pose_.y_m});
  constexpr double touch_m = 0.001;
  const double gap_m = wall.distance_m - config_.bumper_radius_m;
  touching_ = gap_m < touch_m;
  free_way_m_ = gap_m - touch_m;
  if (!touching_) return;
  free_way_m_ = 0.0;
  const double ahead = cos_heading_ * wall.towards.x_m + sin_heading_ * wall.towards.y_m;
  const double aside = cos_heading_ * wall.towards.y_m - sin_heading_ * wall.towards.x_m;
  touch_bearing_rad_ = std::atan2(aside, ahead);
  if (gap_m > 0.0) return;
  pose_.x_m += gap_m * wall.towards.x_m;
  pose_.y_m += gap_m * wall.towards.y_m;
  if (forward_m_s_ * ahead > 0.0) forward_m_s_ *= 1.0 - ahead * ahead;
}

Pose Chassis::pose_after(double duration_s) const {
  const double middle_rad = pose_.theta_rad + 0.5 * turn_rad_s_ * duration_s;
  return {pose_.x_m + forward_m_s_ * duration_s * std::cos(middle_rad),
          pose_.y_m + forward_m_s_ * duration_s * std::sin(middle_rad),
          pose_.theta_rad + turn_rad_s_ * duration_s};
}

double Chassis::kinetic_energy_j() const {
  return 0.5 * (config_.mass_kg * forward_m_s_ * forward_m_s_ +
                config_.yaw_inertia_kg_m2 * turn_rad_s_ * turn_rad_s_);
}

Point Chassis::in_room(double x_m, double y_m) const {
  return {pose_.x_m + cos_heading_ * x_m - sin_heading_ * y_m,
          pose_.y_m + sin_heading_ * x_m + cos_heading_ * y_m};
}

}  // namespace wheelwright::simulation
