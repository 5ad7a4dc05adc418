#pragma once

namespace plants::third {

// Speed controller of one wheel: the command is fed forward; a closed loop adds PI control towards a
// reference model of first order. Its output is a voltage, said as the steady speed that it would give.
struct ControllerSpec {
  bool closed_loop = false;
  double response_s = 0.06;  // time constant of the reference model
  double proportional = 0.0;
  double integral_1_s = 0.0;
};

class WheelController {
 public:
  explicit WheelController(const ControllerSpec& spec) : spec_(spec) {}

  double demand_m_s(double target_m_s, double measured_m_s, double step_s) {
    if (!spec_.closed_loop) return target_m_s;
    model_m_s_ += step_s / spec_.response_s * (target_m_s - model_m_s_);
    return target_m_s + spec_.proportional * (target_m_s - measured_m_s) + spec_.integral_1_s * integral_m_;
  }

  // Not to be called while the motor is held back: the integral would wind up.
  void integrate(double measured_m_s, double step_s) { integral_m_ += step_s * (model_m_s_ - measured_m_s); }

 private:
  ControllerSpec spec_;
  double model_m_s_ = 0.0;
  double integral_m_ = 0.0;
};

}  // namespace plants::third
