// A linear change of how a robot answers its commands, in terms that an engineer sets: gain, delay and lag.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright::gap {

struct CommandCorrection {
  WheelPair gain{1.0, 1.0};
  double delay_s = 0.0;  // later, or sooner where negative
  double lag_s = 0.0;    // added to that of the model, which must not become negative
};

// Commands after which a model answers as the corrected one does to `commands`. With T the period and tau the
// lag of the model, the delay is a shift, linear between periods, and the lag the filter (1 + tau s) / (1 +
// (tau + lag) s) by matched poles.
std::vector<WheelPair> corrected(std::span<const WheelPair> commands, const CommandCorrection& correction,
                                 double period_s, double model_lag_s);

// The spread in time of a model's impulse response, s: the time constant of a first-order lag behind any
// delay. At least a period, also of a response that rings.
double lag_of(const LinearModel& model);

}  // namespace wheelwright::gap
