// One side's motor, gear and wheel: from a voltage at the motor to a torque and a speed at the wheel.
//
// Angles and speeds are those of the wheel; the motor's are divided by the gear ratio. The encoder sits on
// the motor's side of the gear, so that backlash is invisible to it.
#pragma once

#include "drivers/simulation/bearing_friction.hpp"
#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class DriveUnit {
 public:
  explicit DriveUnit(const WheelConfig& config);

  // Motor torque and friction act for `duration_s`; what the floor does comes after, by `push`. A duty of 1
  // is the whole supply voltage, forward.
  void drive(double duty, double supply_v, double duration_s);

  // The floor brakes the wheel with a torque: afterwards `speed_rad_s` has changed by
  // -torque * inverse_inertia() * duration.
  void push(double torque_nm, double duration_s);

  // Turns wheel and motor on at their speeds and lets the gear's teeth meet.
  void turn(double duration_s);

  // How easily the floor changes the wheel's speed: of the wheel alone while the gear's teeth are apart, else
  // of wheel and motor; 0 while it is stalled.
  double inverse_inertia() const;
  double rolling_radius_m() const;
  double speed_rad_s() const { return wheel_speed_rad_s_; }
  double encoder_angle_rad() const { return motor_angle_rad_; }
  double current_a() const { return current_a_; }  // through the winding, signed
  double kinetic_energy_j() const;

  void set_stalled(bool stalled) { stalled_ = stalled; }

 private:
  enum class Teeth { apart, push_forward, push_backward };
  bool has_backlash() const { return config_.backlash_rad > 0.0; }
  bool teeth_are_apart() const { return has_backlash() && teeth_ == Teeth::apart; }
  void warm_up(double duration_s);
  double motor_current_a(double duty, double supply_v) const;
  void let_teeth_meet();

  WheelConfig config_;
  BearingFriction friction_;
  double torque_nm_per_a_;
  double motor_angle_rad_ = 0.0;
  double motor_speed_rad_s_ = 0.0;
  double wheel_angle_rad_ = 0.0;
  double wheel_speed_rad_s_ = 0.0;
  double current_a_ = 0.0;
  double gear_torque_nm_ = 0.0;  // from motor to wheel, while the teeth touch
  double warmth_ = 0.0;          // 0 cold, 1 warm
  Teeth teeth_ = Teeth::apart;
  bool stalled_ = false;
};

}  // namespace wheelwright::simulation
