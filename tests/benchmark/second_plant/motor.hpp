#pragma once

#include <limits>

namespace plants::second {

// Brushed motor with its bridge, seen through the gear: speeds and forces are those at the wheel rim.
struct MotorSpec {
  double emf_v_s_m = 15.0;  // back-EMF per rim speed; the force constant in N/A is the same number
  double resistance_ohm = 10.0;
  double inductance_h = 0.015;
  double rotor_mass_kg = 1.0;  // rotor inertia as a mass at the rim
  double supply_v = 15.0;      // what the bridge can give
  double supply_resistance_ohm = 0.0;
  double pwm_bend = 0.0;            // discontinuous conduction: low duty gives more than its share of voltage
  double brush_advance = 0.0;       // relative change of the motor constant with the sense of rotation
  double braking_resistance = 0.0;  // extra resistance of the braking path, relative to the winding
  double current_limit_a = std::numeric_limits<double>::infinity();
};

class Motor {
 public:
  explicit Motor(const MotorSpec& spec) : spec_(spec) {}

  double force_n(double demanded_v, double speed_m_s, double step_s);

  [[nodiscard]] double current_a() const { return current_a_; }
  // The bridge or the current limiter held the motor back in the last step.
  [[nodiscard]] bool limited() const { return limited_; }

 private:
  [[nodiscard]] double bridge_v(double demanded_v) const;

  MotorSpec spec_;
  double current_a_ = 0.0;
  bool limited_ = false;
};

}  // namespace plants::second
