#pragma once

#include <algorithm>

namespace plants::fourth {

// An open-circuit voltage that falls with the time in use, behind a resistance with a little memory.
struct BatterySpec {
  double full_v = 14.4;
  double fall_v_s = 0.002;
  double sag_v = 0.3;  // with both wheels at top speed
  double sag_lag_s = 0.4;
  double noise_v = 0.01;        // of the measurement
  double fall_between_v = 0.1;  // from the start of one run to that of the next
};

class Battery {
 public:
  Battery(const BatterySpec& spec, double start_v) : spec_(spec), open_v_(start_v) {}

  // `effort` is the mean size of both wheels' speeds over the top speed.
  double step(double effort, double step_s) {
    open_v_ -= spec_.fall_v_s * effort * step_s;
    sagging_v_ += (spec_.sag_v * effort - sagging_v_) * std::min(1.0, step_s / spec_.sag_lag_s);
    return open_v_ - sagging_v_;
  }

 private:
  BatterySpec spec_;
  double open_v_;
  double sagging_v_ = 0.0;
};

}  // namespace plants::fourth
