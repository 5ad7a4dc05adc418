#include "tests/benchmark/fifth_plant/motor_drive.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

MotorDrive::MotorDrive(const SideSpec& spec, const Random& random)
    : spec_(spec), disturbance_(spec.motor.disturbance_n_m, spec.motor.disturbance_memory_s, random) {}

double MotorDrive::back_constant() const {
  return spec_.motor.constant_v_s * (speed_rad_s_ < 0.0 ? spec_.motor.reverse_share : 1.0);
}

void MotorDrive::control(double wanted_rad_s) {
  const MotorSpec& motor = spec_.motor;
  const LoopSpec& loop = spec_.loop;
  const double error_rad_s = wanted_rad_s - speed_rad_s_;
  if (!loop.integral) {
    const double drag_v = motor.resistance_ohm * spec_.gear.viscous_n_m_s / motor.constant_v_s;
    volts_ = (motor.constant_v_s + drag_v) * wanted_rad_s + loop.proportional * error_rad_s;
    return;
  }
  const double asked_a = loop.proportional * error_rad_s + integral_a_;
  const double given_a = std::clamp(asked_a, -spec_.driver.limit_a, spec_.driver.limit_a);
  if (given_a == asked_a)
    integral_a_ += loop.proportional * loop.integral_per_s * error_rad_s * loop.period_s;
  volts_ = motor.constant_v_s * speed_rad_s_ + motor.resistance_ohm * given_a;
}

double MotorDrive::driven_v(double supply) {
  const DriverSpec& driver = spec_.driver;
  double size_v = std::max(0.0, std::abs(volts_) - driver.dead_v);
  size_v *= 1.0 - driver.bend * std::min(1.0, size_v / driver.full_v);
  size_v = std::min(size_v, driver.limit_v);
  if (driver.follows_battery) size_v *= supply;
  heat_v2_s_ += fine_step_s * (size_v * size_v - heat_v2_s_ / driver.foldback_cooling_s);
  constexpr double cooled = 0.75;
  if (heat_v2_s_ > driver.foldback_heat_v2_s) hot_ = true;
  if (heat_v2_s_ < cooled * driver.foldback_heat_v2_s) hot_ = false;
  if (hot_) size_v *= driver.foldback_share;
  return std::copysign(size_v, volts_);
}

// The parking brake falls in after a stop, and takes a while to let go; the loop does not know of it.
bool MotorDrive::held_by_brake(double wanted_rad_s) {
  constexpr double standing_rad_s = 0.03;
  constexpr double falls_in_s = 0.3;
  if (spec_.driver.brake_release_s == 0.0) return false;
  const bool asked = std::abs(wanted_rad_s) > standing_rad_s;
  asked_s_ = asked ? asked_s_ + fine_step_s : 0.0;
  standing_s_ = asked || std::abs(speed_rad_s_) > standing_rad_s ? 0.0 : standing_s_ + fine_step_s;
  if (standing_s_ > falls_in_s) braked_ = true;
  if (asked_s_ > spec_.driver.brake_release_s) braked_ = false;
  return braked_;
}

void MotorDrive::pass_current(double driven_v) {
  const MotorSpec& motor = spec_.motor;
  const double target_a = (driven_v - back_constant() * speed_rad_s_) / motor.resistance_ohm;
  current_a_ +=
      (target_a - current_a_) * -std::expm1(-fine_step_s * motor.resistance_ohm / motor.inductance_h);
  current_a_ = std::clamp(current_a_, -spec_.driver.limit_a, spec_.driver.limit_a);
  constexpr double stands_rad_s = 0.3;  // a bridge that cannot brake drives either way from rest
  const bool turns = std::abs(speed_rad_s_) > stands_rad_s;
  if (!spec_.driver.brakes && turns && current_a_ * speed_rad_s_ < 0.0) current_a_ = 0.0;
}

double MotorDrive::drag_n_m() const {
  const GearSpec& gear = spec_.gear;
  const double size_rad_s = std::abs(speed_rad_s_);
  double viscous_n_m_s = gear.viscous_n_m_s;
  if (gear.cold_viscous_n_m_s > 0.0)
    viscous_n_m_s += gear.cold_viscous_n_m_s * std::exp(-time_s_ / gear.warming_s);
  double drag = (viscous_n_m_s + gear.quadratic_n_m_s2 * size_rad_s) * size_rad_s;
  if (gear.resonance_n_m > 0.0) {
    const double off = (size_rad_s - gear.resonance_rad_s) / gear.resonance_width_rad_s;
    drag += gear.resonance_n_m * std::exp(-off * off);
  }
  return std::copysign(drag, speed_rad_s_);
}

// Dry friction takes up to its size from the motion, and stops it where that is enough.
void MotorDrive::turn(double torque_n_m) {
  const GearSpec& gear = spec_.gear;
  double dry_n_m = gear.dry_n_m;
  if (gear.breakaway_n_m > gear.dry_n_m) {
    const double slow = speed_rad_s_ / gear.stribeck_rad_s;
    dry_n_m += (gear.breakaway_n_m - gear.dry_n_m) * std::exp(-slow * slow);
  }
  const double free_rad_s = speed_rad_s_ + fine_step_s / spec_.motor.inertia_kg_m2 * torque_n_m;
  const double taken_rad_s = fine_step_s / spec_.motor.inertia_kg_m2 * dry_n_m;
  speed_rad_s_ = std::copysign(std::max(0.0, std::abs(free_rad_s) - taken_rad_s), free_rad_s);
  angle_rad_ += fine_step_s * speed_rad_s_;
}

void MotorDrive::step(double wanted_rad_s, double load_n_m, double supply) {
  if (time_s_ >= next_control_s_) {
    control(wanted_rad_s);
    next_control_s_ += spec_.loop.period_s;
  }
  pass_current(driven_v(supply));
  constexpr double plain_rad_s = 0.3;  // gears shake a motor that turns and leave it alone while it stands
  const double shaken_n_m = disturbance_.step() * std::tanh(std::abs(speed_rad_s_) / plain_rad_s);
  if (held_by_brake(wanted_rad_s)) {
    speed_rad_s_ = 0.0;
  } else {
    turn(back_constant() * current_a_ + shaken_n_m - drag_n_m() - load_n_m);
  }
  time_s_ += fine_step_s;
}

}  // namespace plants::fifth
