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

// The model with this gain and lag: its responses times the gain, and with T the period and tau the lag of
// the model, behind the filter (1 + tau s) / (1 + (tau + lag) s) by matched poles. What effects make of a
// command is not touched: a step of it stays as large, and a limit where it is.
LinearModel corrected(const LinearModel& model, const CommandCorrection& correction);

// Commands that come so much later, or sooner where negative, linear between periods.
std::vector<WheelPair> delayed(std::span<const WheelPair> commands, double delay_s, double period_s);

// The spread in time of a model's impulse response, s: the time constant of a first-order lag behind any
// delay. At least a period, also of a response that rings.
double lag_of(const LinearModel& model);

}  // namespace wheelwright::gap
