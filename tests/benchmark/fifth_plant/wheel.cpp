#include "tests/benchmark/fifth_plant/wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::fifth {

double Contact::step(double slip_m_s, double rolled_m_s) {
  const double stiffness_n_m = floor_.slip_stiffness_n / floor_.relaxation_m;
  const double bending_m_s = slip_m_s - std::abs(rolled_m_s) / floor_.relaxation_m * bent_m_;
  const double max_m = floor_.grip_n / stiffness_n_m;
  bent_m_ = std::clamp(bent_m_ + fine_step_s * bending_m_s, -max_m, max_m);
  constexpr double damping_s = 0.0006;  // of the rubber
  return std::clamp(stiffness_n_m * (bent_m_ + damping_s * bending_m_s), -floor_.grip_n, floor_.grip_n);
}

Wheel::Wheel(const SideSpec& spec, const FloorSpec& floor, const Random& random)
    : spec_(spec),
      motor_(spec, random.child(0)),
      contact_(floor),
      roughness_(floor.roughness, floor.roughness_memory_s, random.child(1)) {}

// Torque from the gear on the wheel. An eccentric gear wheel turns the shaft at a speed that ripples.
double Wheel::teeth_n_m(double& motor_share) const {
  const GearSpec& gear = spec_.gear;
  const double angle_rad = motor_.angle_rad() + gear.runout_phase_rad;
  motor_share = 1.0 + gear.runout * std::cos(angle_rad);
  const double runout_rad = gear.runout * (std::sin(angle_rad) - std::sin(gear.runout_phase_rad));
  const double twist_rad = motor_.angle_rad() + runout_rad - shaft_rad_;
  const double pressed_rad = std::max(0.0, std::abs(twist_rad) - 0.5 * gear.gap_rad);
  if (pressed_rad == 0.0) return 0.0;
  const double side = std::copysign(1.0, twist_rad);
  const double closing_rad_s = side * (motor_.speed_rad_s() * motor_share - shaft_rad_s_);
  // Teeth push and never pull.
  return side * std::max(0.0, gear.stiffness_n_m * pressed_rad + gear.damping_n_m_s * closing_rad_s);
}

double Wheel::radius_m() {
  const WheelSpec& wheel = spec_.wheel;
  double share = 1.0 + roughness_.step();
  share += wheel.eccentricity * std::cos(shaft_rad_ + wheel.eccentricity_phase_rad);
  share -= wheel.leak * std::min(1.0, time_s_ / wheel.leak_s);
  if (wheel.flat_depth > 0.0) {
    const double off_rad = std::remainder(shaft_rad_, std::numbers::pi) / wheel.flat_width_rad;
    share -= wheel.flat_depth * std::exp(-off_rad * off_rad);
  }
  return wheel.radius_m * share;
}

// The radius is the height of the axle: what lifts it takes the torque of the weight.
double Wheel::climbing_n_m() const {
  const WheelSpec& wheel = spec_.wheel;
  if (wheel.flat_depth == 0.0) return 0.0;
  const double off_rad = std::remainder(shaft_rad_, std::numbers::pi) / wheel.flat_width_rad;
  const double rising_m = 2.0 * wheel.radius_m * wheel.flat_depth * off_rad / wheel.flat_width_rad;
  return wheel.borne_n * rising_m * std::exp(-off_rad * off_rad);
}

// Beyond its limit the hub jumps on by one spline, and takes a while to be pressed hard against the next.
double Wheel::hub_slip_rad_s(double torque_n_m) {
  constexpr double jump_s = 0.08;
  constexpr double rest_s = 1.5;
  if (std::abs(torque_n_m) > spec_.wheel.hub_limit_n_m && time_s_ > jump_again_s_) {
    jump_rad_s_ = std::copysign(spec_.wheel.hub_jump_rad / jump_s, torque_n_m);
    jump_until_s_ = time_s_ + jump_s;
    jump_again_s_ = jump_until_s_ + rest_s;
  }
  return time_s_ < jump_until_s_ ? jump_rad_s_ : 0.0;
}

double Wheel::step(double wanted_m_s, double ground_m_s, double supply) {
  double motor_share = 1.0;
  const double teeth = teeth_n_m(motor_share);
  motor_.step(wanted_m_s / spec_.wheel.said_radius_m, motor_share * teeth, supply);
  const double radius = radius_m();
  const double rolled_m_s = radius * (shaft_rad_s_ - hub_slip_rad_s(teeth));
  const double force_n = contact_.step(rolled_m_s - ground_m_s, rolled_m_s);
  const double share = fine_step_s / spec_.wheel.inertia_kg_m2;
  const double free_rad_s = shaft_rad_s_ + share * (teeth - radius * force_n - climbing_n_m());
  shaft_rad_s_ =
      std::copysign(std::max(0.0, std::abs(free_rad_s) - share * spec_.wheel.drag_n_m), free_rad_s);
  shaft_rad_ += fine_step_s * shaft_rad_s_;
  time_s_ += fine_step_s;
  return force_n;
}

}  // namespace plants::fifth
