#pragma once

#include "tests/benchmark/fifth_plant/noise.hpp"
#include "tests/benchmark/fifth_plant/robot.hpp"

namespace plants::fifth {

// Loop, driver, motor and the friction of the gear, up to the teeth that drive the wheel.
class MotorDrive {
 public:
  MotorDrive(const SideSpec& spec, const Random& random);

  // One fine step. `load_n_m` is what the teeth take, `supply` the battery's share of its nominal voltage.
  void step(double wanted_rad_s, double load_n_m, double supply);

  [[nodiscard]] double speed_rad_s() const { return speed_rad_s_; }
  [[nodiscard]] double angle_rad() const { return angle_rad_; }
  [[nodiscard]] double current_a() const { return current_a_; }
  [[nodiscard]] double input_w() const { return volts_ * current_a_; }

 private:
  void control(double wanted_rad_s);
  [[nodiscard]] double back_constant() const;
  [[nodiscard]] double driven_v(double supply);
  bool held_by_brake(double wanted_rad_s);
  void pass_current(double driven_v);
  [[nodiscard]] double drag_n_m() const;
  void turn(double torque_n_m);

  SideSpec spec_;
  SlowNoise disturbance_;
  double time_s_ = 0.0;
  double next_control_s_ = 0.0;
  double integral_a_ = 0.0;
  double volts_ = 0.0;
  double heat_v2_s_ = 0.0;
  bool hot_ = false;
  double asked_s_ = 0.0;
  double standing_s_ = 0.0;
  bool braked_ = false;
  double current_a_ = 0.0;
  double speed_rad_s_ = 0.0;
  double angle_rad_ = 0.0;
};

}  // namespace plants::fifth
