#pragma once

#include <limits>

#include "tests/benchmark/fourth_plant/block.hpp"

namespace plants::fourth {

// Dry friction as the drive feels it: the change of drive, in m/s of free wheel speed, that it eats up.
struct Friction {
  double moving_m_s = 0.0;
  double breakaway_m_s = 0.0;   // at rest
  double stribeck_m_s = 0.004;  // speed at which breakaway has faded into moving
  [[nodiscard]] double level_m_s(double speed_m_s) const;
};

// An amplifier lag and a mechanical lag, behind a second-order command filter or not, in a loop or not.
struct DriveSpec {
  double gain = 1.0;
  double amplifier_lag_s = 0.012;
  double mechanical_lag_s = 0.08;
  bool filtered = false;
  double filter_rad_s = 25.0;
  double filter_damping = 0.9;
  bool in_loop = false;
  double proportional = 0.0;  // the command is also fed forward
  double integral_per_s = 0.0;
  double drive_limit_m_s = std::numeric_limits<double>::infinity();
  double unwinding_per_s = 20.0;  // anti-windup by back-calculation
  Friction friction;
};

// From the speed that is asked for to the speed of the motor, in steps that hold the input.
class WheelDrive {
 public:
  WheelDrive(const DriveSpec& spec, double step_s);

  // `drive` lies between controller and motor, `load` turns the motor's speed into a loss of drive.
  double step(double asked_m_s, Chain& drive, Chain& load, const Moment& moment);

 private:
  double filtered(double asked_m_s);
  double controlled(double asked_m_s);
  void turn_motor(double drive_m_s, double loss_m_s);

  DriveSpec spec_;
  double step_s_;
  double amplifier_decay_;
  double mechanical_decay_;
  double coupling_;  // of the amplifier's deviation into the speed, in one step
  double filter_m_s_ = 0.0;
  double filter_slope_m_s2_ = 0.0;
  double integral_m_s_ = 0.0;
  double amplifier_m_s_ = 0.0;
  double speed_m_s_ = 0.0;
};

}  // namespace plants::fourth
