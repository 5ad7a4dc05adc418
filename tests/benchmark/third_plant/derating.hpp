#pragma once

#include "tests/benchmark/plants/random.hpp"

namespace plants::third {

// What takes some of the drive's voltage and is no effect of the library.
struct DeratingSpec {
  double shared_droop_1_a = 0.0;  // both motors on one weak regulator
  double protection = 0.0;        // share that thermal protection takes from a random moment on
  double fluid_memory = 0.0;      // fluid coupling whose gain falls with the mean speed of the last seconds
};

class Derating {
 public:
  Derating(const DeratingSpec& spec, double run_s, Random random)
      : spec_(spec), protected_from_s_(random.uniform(0.25, 0.75) * run_s) {}

  // `use` is the sum of both wheels' speeds over the largest command.
  void step(double use, double step_s) {
    constexpr double memory_s = 8.0;
    mean_use_ += step_s * (0.5 * use - mean_use_) / memory_s;
  }

  [[nodiscard]] double share(double now_s, double motor_current_a) const {
    double left = 1.0 - spec_.shared_droop_1_a * motor_current_a;
    if (now_s > protected_from_s_) left *= 1.0 - spec_.protection;
    constexpr double gain_at_rest = 1.1;
    if (spec_.fluid_memory > 0.0) left *= gain_at_rest - spec_.fluid_memory * mean_use_;
    return left;
  }

 private:
  DeratingSpec spec_;
  double protected_from_s_;
  double mean_use_ = 0.0;
};

}  // namespace plants::third
