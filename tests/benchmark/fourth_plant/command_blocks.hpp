// Blocks on a commanded or a driven speed, in the forms that a toolbox of control blocks has them.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/benchmark/fourth_plant/block.hpp"

namespace plants::fourth {

inline double with_sign_of(double size, double sign) {
  return std::copysign(size, sign);
}

// The line of a firmware that spares its motors: too small a command is no command.
struct Threshold {
  double threshold_m_s;
  double operator()(double input, const Moment& /*moment*/) const {
    return std::abs(input) < threshold_m_s ? 0.0 : input;
  }
};

struct Limiter {
  double limit_m_s;
  double operator()(double input, const Moment& /*moment*/) const {
    return std::clamp(input, -limit_m_s, limit_m_s);
  }
};

struct RateLimiter {
  double limit_m_s2;
  double output_m_s = 0.0;
  double operator()(double input, const Moment& moment) {
    const double reach_m_s = limit_m_s2 * moment.step_s;
    output_m_s += std::clamp(input - output_m_s, -reach_m_s, reach_m_s);
    return output_m_s;
  }
};

struct Quantizer {
  double interval_m_s;
  double operator()(double input, const Moment& /*moment*/) const {
    return interval_m_s * std::round(input / interval_m_s);
  }
};

// A parabola through zero and the top speed: gain above one below, falling to the top.
struct BentGain {
  double bend;
  double top_m_s;
  double operator()(double input, const Moment& /*moment*/) const {
    return input * (1.0 + bend * (1.0 - std::abs(input) / top_m_s));
  }
};

// A curve that flattens out, as of a motor with a soft characteristic.
struct FlatteningGain {
  double bend;
  double top_m_s;
  double operator()(double input, const Moment& /*moment*/) const {
    return top_m_s * std::tanh(bend * input / top_m_s) / std::tanh(bend);
  }
};

struct ReverseGain {
  double gain;
  double operator()(double input, const Moment& /*moment*/) const {
    return input < 0.0 ? gain * input : input;
  }
};

// A first-order lag that is quicker upwards than downwards, as of a bridge that lets the motor coast.
struct CoastingLag {
  double up_s;
  double down_s;
  double output_m_s = 0.0;
  double operator()(double input, const Moment& moment) {
    const bool slowing_down = input * output_m_s < 0.0 || std::abs(input) < std::abs(output_m_s);
    const double lag_s = slowing_down ? down_s : up_s;
    output_m_s += (input - output_m_s) * (1.0 - std::exp(-moment.step_s / lag_s));
    return output_m_s;
  }
};

// Magnets and grease that warm up: the gain goes exponentially to where it stays.
struct WarmingGain {
  double change;
  double time_constant_s;
  double operator()(double input, const Moment& moment) const {
    return input * (1.0 + change * (1.0 - std::exp(-moment.time_s / time_constant_s)));
  }
};

struct SupplyGain {
  double nominal_v;
  double operator()(double input, const Moment& moment) const { return input * moment.battery_v / nominal_v; }
};

}  // namespace plants::fourth
