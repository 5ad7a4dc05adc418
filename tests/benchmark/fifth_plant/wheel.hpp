#pragma once

#include "tests/benchmark/fifth_plant/motor_drive.hpp"

namespace plants::fifth {

// Force of a tyre whose contact is held by bristles: they bend with the slip, straighten as the tyre rolls
// on, and let go at the limit of grip.
class Contact {
 public:
  explicit Contact(const FloorSpec& floor) : floor_(floor) {}

  // Force on the body.
  double step(double slip_m_s, double rolled_m_s);

 private:
  FloorSpec floor_;
  double bent_m_ = 0.0;
};

// A wheel with its drive: two inertias with the teeth of the gear in between.
class Wheel {
 public:
  Wheel(const SideSpec& spec, const FloorSpec& floor, const Random& random);

  // One fine step; returns the force on the body, whose contact point moves at `ground_m_s`.
  double step(double wanted_m_s, double ground_m_s, double supply);

  [[nodiscard]] double shaft_rad() const { return shaft_rad_; }
  [[nodiscard]] double shaft_rad_s() const { return shaft_rad_s_; }
  [[nodiscard]] const MotorDrive& motor() const { return motor_; }

 private:
  [[nodiscard]] double teeth_n_m(double& motor_share) const;
  [[nodiscard]] double radius_m();
  [[nodiscard]] double climbing_n_m() const;
  double hub_slip_rad_s(double torque_n_m);

  SideSpec spec_;
  MotorDrive motor_;
  Contact contact_;
  SlowNoise roughness_;
  double time_s_ = 0.0;
  double shaft_rad_ = 0.0;
  double shaft_rad_s_ = 0.0;
  double jump_until_s_ = 0.0;
  double jump_again_s_ = 0.0;
  double jump_rad_s_ = 0.0;
};

}  // namespace plants::fifth
