#pragma once

namespace plants::third {

// Brushed motor and its bridge, seen through the gear: speeds, forces and the motor constant are those at the
// wheel rim. Zero: no such imperfection.
struct MotorSpec {
  double constant_n_a = 15.0;  // the back-EMF in V s/m is the same number
  double resistance_ohm = 10.0;
  double electrical_time_s = 0.002;
  double volts_per_m_s = 15.0;  // of steady speed, with the drag of the gear
  double full_scale_m_s = 0.35;
  double gain_at_rest = 0.0;        // PWM with slow decay: gain at small demands,
  double gain_drop = 0.0;           // and what full scale loses of it
  double clamp_v = 0.0;             // hard limit of the bridge
  double knee_v = 0.0;              // smooth limit of the bridge
  double brush_advance = 0.0;       // relative change of the motor constant with the sense of rotation
  double braking_resistance = 0.0;  // of the diode path, relative to the winding
  double force_limit_n = 0.0;       // current limit, as the force that it leaves beside the drag
  double drag_n_s_m = 3.0;          // of the gear
};

class Motor {
 public:
  explicit Motor(const MotorSpec& spec) : spec_(spec) {}

  // `supply` is the share of the voltage asked for that the supply really gives.
  double force_n(double demand_m_s, double supply, double speed_m_s, double step_s);

  // A loose plug.
  void cut_current() { current_a_ = 0.0; }

  [[nodiscard]] double current_a() const { return current_a_; }
  // The bridge or the current limit held the motor back in the last step.
  [[nodiscard]] bool held_back() const { return held_back_; }

 private:
  [[nodiscard]] double curved_m_s(double demand_m_s) const;
  double bridge_v(double wanted_v);
  void limit_current(double constant_n_a, double speed_m_s);

  MotorSpec spec_;
  double current_a_ = 0.0;
  bool held_back_ = false;
};

}  // namespace plants::third
