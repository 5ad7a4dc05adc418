#include "tests/support/gap_plant/floor_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright::test {
namespace {

constexpr double rolling_m_s = 0.01;  // scale of speed below which a wheel counts as resting

// Fiala's brush tyre, solved for the slip that a demanded acceleration needs; 1 at 3 m/s^2.
double brush_slip(double acceleration_m_s2) {
  constexpr double adhesion_m_s2 = 8.0;
  const auto slip = [](double share) { return 1.0 - std::cbrt(1.0 - std::min(share, 0.99)); };
  return slip(std::abs(acceleration_m_s2) / adhesion_m_s2) / slip(3.0 / adhesion_m_s2);
}

// Share of the turn rate that scrubbing takes: little in wide bends, more in tight ones; 1 at 2 rad/s.
double scrubbed(double w_rad_s) {
  constexpr double bend = 1.5;
  const double square = w_rad_s * w_rad_s;
  return square / (square + bend * bend) * (4.0 + bend * bend) / 4.0;
}

}  // namespace

FloorContact::FloorContact(const PlantParameters& robot, const Pose& start, double dt_s, std::uint64_t seed)
    : robot_(robot), dt_s_(dt_s), pose_(start), random_(seed) {}

// A wheel finds more or less grip every few centimetres: noise in travel, not in time.
double FloorContact::grip_noise(double& state, double travel_m) {
  const double keep = std::exp(-std::abs(travel_m) / robot_.slip_noise_length_m);
  state = keep * state + std::sqrt(1.0 - keep * keep) * robot_.slip_noise_share * normal_(random_);
  return 1.0 + state;
}

void FloorContact::step(const WheelPair& travel_m, double hardest_m_s2) {
  const double hop =
      robot_.hop_share > 0.0 ? 1.0 - std::min(0.9, robot_.hop_share * brush_slip(hardest_m_s2)) : 1.0;
  const double left_m = travel_m.left * robot_.rolling.left * hop * grip_noise(grip_.left, travel_m.left);
  const double right_m =
      travel_m.right * robot_.rolling.right * hop * grip_noise(grip_.right, travel_m.right);
  twist_ =
      twist_of_wheels({left_m / dt_s_, right_m / dt_s_}, robot_.wheel_base_m * (1.0 + robot_.track_share));
  upset_ = upset();
  if (!robot_.upset_loads_motors) {
    constexpr double relaxation_s = 0.03;
    slipped_.v_m_s += dt_s_ / relaxation_s * (upset_.v_m_s - slipped_.v_m_s);
    slipped_.w_rad_s += dt_s_ / relaxation_s * (upset_.w_rad_s - slipped_.w_rad_s);
    twist_.v_m_s += slipped_.v_m_s;
    twist_.w_rad_s += slipped_.w_rad_s;
  }
  pose_ = move_along_arc(pose_, twist_, dt_s_);
}

WheelPair FloorContact::load_m_s() const {
  if (!robot_.upset_loads_motors) return {};
  return wheels_of_twist(upset_, robot_.wheel_base_m);
}

Twist FloorContact::upset() {
  const double v = twist_.v_m_s;
  const double w = twist_.w_rad_s;
  const double rolls = std::tanh((std::abs(v) + 0.5 * robot_.wheel_base_m * std::abs(w)) / rolling_m_s);
  Twist sum;
  sum.v_m_s -= robot_.turn_drag_m * std::abs(w) * std::tanh(v / (2.0 * rolling_m_s));
  sum.v_m_s -= robot_.slope_m_s * std::cos(pose_.theta_rad - robot_.uphill_rad) * rolls;
  sum.w_rad_s -= robot_.scrub_share * scrubbed(w) * w;
  sum.w_rad_s += robot_.yaw_bias_rad_s * rolls;
  if (robot_.patch_share > 0.0 && on_patch()) {
    sum.v_m_s -= robot_.patch_share * v;
    sum.w_rad_s -= robot_.patch_share * w;
  }
  if (robot_.caster_kick_rad != 0.0) sum.w_rad_s += caster_turn_rad_s();
  return sum;
}

// A caster whose direction of travel flips stands against it and swings round within some trail lengths;
// while it stands across, it pushes the body sideways.
double FloorContact::caster_turn_rad_s() {
  constexpr double trail_m = 0.03;
  constexpr double nearly = 0.05;
  const double v = twist_.v_m_s;
  if (std::abs(v) > 0.5 * rolling_m_s && v * direction_ <= 0.0) {
    if (direction_ != 0.0) {
      caster_rad_ = std::clamp(std::numbers::pi - caster_rad_, nearly, std::numbers::pi - nearly);
      if (robot_.caster_turns_on) caster_side_ = -caster_side_;
    }
    direction_ = v;
  }
  const double across = std::sin(caster_rad_);
  caster_rad_ -= dt_s_ * std::abs(v) / trail_m * across;
  return caster_side_ * robot_.caster_kick_rad / (std::numbers::pi * trail_m) * std::abs(v) * across;
}

bool FloorContact::on_patch() const {
  const Pose inside = between(robot_.patch, pose_);
  return std::abs(inside.x_m) < 0.5 * robot_.patch_length_m &&
         std::abs(inside.y_m) < 0.5 * robot_.patch_width_m;
}

}  // namespace wheelwright::test
