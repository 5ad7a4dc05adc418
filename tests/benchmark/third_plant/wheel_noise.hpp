#pragma once

#include <algorithm>
#include <cmath>

#include "tests/benchmark/plants/random.hpp"

namespace plants::third {

// Roughness of gear and floor: a first-order Markov process that lives where the wheel moves.
struct WheelNoiseSpec {
  double speed_m_s = 0.0015;
  double correlation_s = 0.1;
};

class WheelNoise {
 public:
  WheelNoise(const WheelNoiseSpec& spec, Random random) : spec_(spec), random_(random) {}

  double step_m_s(double wheel_m_s, double step_s) {
    constexpr double moving_m_s = 0.03;
    const double share = step_s / spec_.correlation_s;
    state_ += -share * state_ + random_.normal(std::sqrt(2.0 * share));
    return spec_.speed_m_s * state_ * std::min(1.0, std::abs(wheel_m_s) / moving_m_s);
  }

 private:
  WheelNoiseSpec spec_;
  Random random_;
  double state_ = 0.0;
};

}  // namespace plants::third
