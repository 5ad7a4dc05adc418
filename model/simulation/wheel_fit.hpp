// How well a linear model fits one wheel: what a model file keeps of its fit.
#pragma once

#include "model/simulation/linear_model.hpp"

namespace wheelwright {

struct WheelFit {
  DcGain gain;  // m/s per m/s
  DcGain gain_standard_error;
  double position_noise_m = 0.0;    // standard deviation of one reading of wheel travel
  double drift_m_per_sqrt_s = 0.0;  // random walk of wheel travel at first; may fade
};

}  // namespace wheelwright
