#include "drivers/simulation/drive_unit.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::simulation {

DriveUnit::DriveUnit(const WheelConfig& config)
    : config_(config),
      friction_(config.friction, config.motor.inertia_kg_m2 + config.inertia_kg_m2),
      torque_nm_per_a_(config.motor.back_emf_v_s_per_rad * config.motor_strength) {}

double DriveUnit::motor_current_a(double duty, double supply_v) const {
  const double resistance_ohm =
      config_.motor.resistance_ohm * (1.0 + config_.motor.resistance_change_when_warm * warmth_);
  const double current_a = (duty * supply_v - torque_nm_per_a_ * motor_speed_rad_s_) / resistance_ohm;
  const bool against_duty = current_a * duty <= 0.0;
  return against_duty && !config_.motor.bridge_can_brake ? 0.0 : current_a;
}

void DriveUnit::drive(double duty, double supply_v, double duration_s) {
  if (stalled_) motor_speed_rad_s_ = wheel_speed_rad_s_ = 0.0;
  current_a_ = motor_current_a(duty, supply_v);
  if (stalled_) return;
  warm_up(duration_s);
  const double friction_scale = 1.0 + config_.motor.friction_change_when_warm * warmth_;
  const double torque_nm =
      torque_nm_per_a_ * current_a_ - friction_.torque_nm(motor_speed_rad_s_, friction_scale, duration_s);
  const bool pulled_apart = (teeth_ == Teeth::push_forward && gear_torque_nm_ < 0.0) ||
                            (teeth_ == Teeth::push_backward && gear_torque_nm_ > 0.0);
  if (pulled_apart) teeth_ = Teeth::apart;
  const double moved_kg_m2 = config_.motor.inertia_kg_m2 + (teeth_are_apart() ? 0.0 : config_.inertia_kg_m2);
  const double change_rad_s = duration_s * torque_nm / moved_kg_m2;
  motor_speed_rad_s_ += change_rad_s;
  if (teeth_are_apart()) return;
  wheel_speed_rad_s_ = motor_speed_rad_s_;
  gear_torque_nm_ = config_.inertia_kg_m2 * change_rad_s / duration_s;
}

void DriveUnit::warm_up(double duration_s) {
  const double goal = std::abs(motor_speed_rad_s_) > 0.1 ? 1.0 : 0.0;
  warmth_ += (goal - warmth_) * duration_s / config_.motor.warm_up_time_s;
}

void DriveUnit::push(double torque_nm, double duration_s) {
  const double change_rad_s = -torque_nm * inverse_inertia() * duration_s;
  wheel_speed_rad_s_ += change_rad_s;
  if (teeth_are_apart()) return;
  motor_speed_rad_s_ = wheel_speed_rad_s_;
  gear_torque_nm_ += torque_nm + config_.inertia_kg_m2 * change_rad_s / duration_s;
}

void DriveUnit::turn(double duration_s) {
  motor_angle_rad_ += motor_speed_rad_s_ * duration_s;
  wheel_angle_rad_ += wheel_speed_rad_s_ * duration_s;
  if (has_backlash()) {
    let_teeth_meet();
  } else {
    wheel_angle_rad_ = motor_angle_rad_;
  }
}

void DriveUnit::let_teeth_meet() {
  const double ahead_rad = motor_angle_rad_ - wheel_angle_rad_;
  const double play_rad = 0.5 * config_.backlash_rad;
  if (teeth_ != Teeth::apart || std::abs(ahead_rad) < play_rad) return;
  teeth_ = ahead_rad > 0.0 ? Teeth::push_forward : Teeth::push_backward;
  gear_torque_nm_ = 0.0;
  motor_angle_rad_ = wheel_angle_rad_ + std::copysign(play_rad, ahead_rad);
  // The teeth do not bounce: both go on with their common momentum.
  const double motor_share =
      config_.motor.inertia_kg_m2 / (config_.motor.inertia_kg_m2 + config_.inertia_kg_m2);
  wheel_speed_rad_s_ = motor_share * motor_speed_rad_s_ + (1.0 - motor_share) * wheel_speed_rad_s_;
  motor_speed_rad_s_ = wheel_speed_rad_s_;
}

double DriveUnit::inverse_inertia() const {
  if (stalled_) return 0.0;
  return 1.0 / (config_.inertia_kg_m2 + (teeth_are_apart() ? 0.0 : config_.motor.inertia_kg_m2));
}

double DriveUnit::rolling_radius_m() const {
  const double radius_m = 0.5 * config_.diameter_m;
  if (config_.eccentricity == 0.0) return radius_m;
  return radius_m *
         (1.0 + config_.eccentricity * std::cos(wheel_angle_rad_ - config_.eccentricity_phase_rad));
}

double DriveUnit::kinetic_energy_j() const {
  return 0.5 * (config_.motor.inertia_kg_m2 * motor_speed_rad_s_ * motor_speed_rad_s_ +
                config_.inertia_kg_m2 * wheel_speed_rad_s_ * wheel_speed_rad_s_);
}

}  // namespace wheelwright::simulation
