#include "tests/benchmark/third_plant/supply.hpp"

#include <algorithm>

namespace plants::third {

void Supply::step(double now_s, double motor_current_a, double use, double step_s) {
  constexpr double default_run_s = 80.0;
  constexpr double smoothing_s = 0.01;  // of the capacitors
  if (now_s > auxiliary_until_s_) {
    auxiliary_on_ = !auxiliary_on_;
    auxiliary_until_s_ = now_s + random_.uniform(4.0, 12.0);
  }
  const double load = 0.4 + 0.9 * std::min(1.5, use);
  open_circuit_v_ -= step_s * spec_.drop_in_run_v / default_run_s * load;
  const double current_a = motor_current_a + (auxiliary_on_ ? spec_.auxiliary_a : 0.0);
  const double settled_v = open_circuit_v_ - spec_.internal_ohm * current_a;
  terminal_v_ += (settled_v - terminal_v_) * std::min(1.0, step_s / smoothing_s);
}

}  // namespace plants::third
