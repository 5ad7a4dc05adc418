#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// A motor, its gear and its wheel: two masses with the teeth in between, as seen at the rim.
class Wheel {
 public:
  // With `engaged` the teeth touch from the start as they do when driving forward.
  Wheel(const Robot& robot, const Hidden& hidden, std::size_t side, bool engaged, Random& chance);

  // Voltages are in metres per second of speed without load.
  double wanted_voltage_m_s(double time_s, double duty_m_s);
  [[nodiscard]] double pull_n(double voltage_m_s) const;
  // Moves the motor on; the wheel waits for `roll`.
  void turn_motor(double time_s, double motor_n);
  // Force of the tyre on the body.
  double push_n(double ground_m_s, double track_m, double more_drag_n_s_m);
  void roll();

  [[nodiscard]] double rim_m_s() const { return wheel_m_s_; }

 private:
  [[nodiscard]] double teeth_n() const;
  [[nodiscard]] double tooth_n() const;
  [[nodiscard]] double friction_n() const;
  [[nodiscard]] double size_share() const;

  const Robot& robot_;
  const Hidden& hidden_;
  std::size_t side_;
  double motor_m_s_ = 0.0;
  double wheel_m_s_ = 0.0;
  double twist_m_ = 0.0;
  double rolled_m_ = 0.0;
  double angle_rad_;
  double integral_m_s_ = 0.0;
  double size_share_ = 1.0;  // of the wheel, for what the log says
  double pressed_n_ = 0.0;
  double wheel_m_s2_ = 0.0;
  double most_pull_n_ = 1e9;
  double most_push_n_ = 1e9;
};

}  // namespace plants::sixth
