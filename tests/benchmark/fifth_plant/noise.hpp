#pragma once

#include <cmath>

#include "tests/benchmark/fifth_plant/robot.hpp"
#include "tests/benchmark/plants/random.hpp"

namespace plants::fifth {

// Noise that forgets itself in `memory_s`, held for some steps.
class SlowNoise {
 public:
  SlowNoise(double sigma, double memory_s, const Random& random)
      : random_(random),
        keep_(std::exp(-held_steps * fine_step_s / memory_s)),
        fresh_(sigma * std::sqrt(1.0 - keep_ * keep_)) {}

  double step() {
    if (fresh_ != 0.0 && step_++ % held_steps == 0) value_ = keep_ * value_ + random_.normal(fresh_);
    return value_;
  }

 private:
  static constexpr int held_steps = 4;

  Random random_;
  double keep_;
  double fresh_;
  int step_ = 0;
  double value_ = 0.0;
};

}  // namespace plants::fifth
