#pragma once

namespace plants::second {

// Speed controller of one wheel: feed-forward plus PI on the motor's own tachometer.
struct ControllerSpec {
  double feedforward_v_s_m = 15.0;
  double proportional_v_s_m = 0.0;
  double integral_v_m = 0.0;
  double hunting_v = 0.0;  // relay of a position loop that hunts; 0 = none
  double hunting_band_m = 0.0;
};

class WheelController {
 public:
  explicit WheelController(const ControllerSpec& spec) : spec_(spec) {}

  double voltage_v(double target_m_s, double measured_m_s, bool motor_limited, double step_s);

 private:
  double hunting_v(double target_m_s, double measured_m_s, double step_s);

  ControllerSpec spec_;
  double integral_m_ = 0.0;
  double position_error_m_ = 0.0;
  double relay_ = 1.0;
};

}  // namespace plants::second
