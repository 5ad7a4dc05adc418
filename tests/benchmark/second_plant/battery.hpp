#pragma once

#include "tests/benchmark/plants/random.hpp"

namespace plants::second {

// Battery pack with internal resistance and another consumer that switches on and off.
struct BatterySpec {
  bool compensated = true;  // the firmware scales its duty by the measured voltage
  double nominal_v = 15.0;
  double full_v = 16.2;
  double drop_per_run_v = 0.1;   // each run starts with a little less charge
  double drop_per_s_v = 0.0005;  // while something is drawn
  double internal_ohm = 0.15;
  double auxiliary_a = 0.3;
  double auxiliary_hold_s = 8.0;  // mean time between switchings
  double noise_v = 0.01;
};

class Battery {
 public:
  Battery(const BatterySpec& spec, int run, Random random)
      : spec_(spec), random_(random), open_circuit_v_(spec.full_v - spec.drop_per_run_v * run) {
    next_switch_s_ = random_.uniform(0.3, 1.7) * spec_.auxiliary_hold_s;
  }

  void step(double now_s, double motor_current_a, double step_s) {
    if (now_s >= next_switch_s_) {
      auxiliary_on_ = !auxiliary_on_;
      next_switch_s_ = now_s + random_.uniform(0.3, 1.7) * spec_.auxiliary_hold_s;
    }
    open_circuit_v_ -= spec_.drop_per_s_v * step_s;
    const double load_a = motor_current_a + (auxiliary_on_ ? spec_.auxiliary_a : 0.0);
    terminal_v_ = open_circuit_v_ - spec_.internal_ohm * load_a;
  }

  [[nodiscard]] double terminal_v() const { return terminal_v_; }
  [[nodiscard]] double bridge_gain() const { return spec_.compensated ? 1.0 : terminal_v_ / spec_.nominal_v; }

 private:
  BatterySpec spec_;
  Random random_;
  double open_circuit_v_;
  double terminal_v_ = 0.0;
  double next_switch_s_ = 0.0;
  bool auxiliary_on_ = false;
};

}  // namespace plants::second
