#pragma once

#include "tests/benchmark/plants/random.hpp"

namespace plants::third {

// The battery. Regulated PWM makes good for what it loses; unregulated PWM sags with it.
struct SupplySpec {
  bool regulated = true;
  double nominal_v = 12.0;
  double open_circuit_v = 12.4;  // at the start of the first run
  double drop_per_run_v = 0.004;
  double drop_in_run_v = 0.064;  // of some 80 s
  double internal_ohm = 0.02;
  double auxiliary_a = 0.0;  // another consumer, which goes on and off
  double noise_v = 0.008;    // of the voltmeter
};

class Supply {
 public:
  Supply(const SupplySpec& spec, int run, Random random)
      : spec_(spec),
        random_(random),
        open_circuit_v_(spec.open_circuit_v - spec.drop_per_run_v * run),
        terminal_v_(open_circuit_v_) {}

  // `use` is the sum of both wheels' speeds over the largest command.
  void step(double now_s, double motor_current_a, double use, double step_s);

  [[nodiscard]] double terminal_v() const { return terminal_v_; }
  // Share of the nominal voltage that the bridges get.
  [[nodiscard]] double share() const { return spec_.regulated ? 1.0 : terminal_v_ / spec_.nominal_v; }

 private:
  SupplySpec spec_;
  Random random_;
  double open_circuit_v_;
  double terminal_v_;
  bool auxiliary_on_ = false;
  double auxiliary_until_s_ = 0.0;
};

}  // namespace plants::third
