// How data differ from the linear part of a model that was given: gain of each wheel, delay, lag.
//
// The model, with all effects that are known, gets a corrected linear part and delayed commands
// (command_correction.hpp).
// Gains, delay and lag are fitted to the training runs by least squares of the innovations; intervals come
// from a bootstrap over blocks of time, and allow for what is not known of the effects.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/linear_changes/command_correction.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

// By which held-out runs have to be likelier with a claim on the given model, deflated: ln(4 / 0.01), one of
// four claims at 1 %.
inline constexpr double confirming_nats = 5.99;

struct LinearChange {
  std::string_view what;   // "gain", "delay" or "lag"
  std::string_view wheel;  // "left", "right" or "both"
  double value = 0.0;      // gain: a factor; delay and lag: what has to be added to the model's
  std::string_view unit;   // "1" or "s"
  ParameterInterval interval;
};

struct LinearChanges {
  std::vector<LinearChange> changes;  // those that are sure and large enough to matter, the delay first
  CommandCorrection correction;       // with all four, sure or not
  double heldout_gain_nats = 0.0;     // of the held-out runs' log likelihood, by the correction, deflated
};

// A change is listed where its 95 % interval leaves out "none", and it is larger than: a gain of 1 %, a delay
// of a quarter of a period or 5 ms, a lag of 15 ms; and where the held-out runs confirm the correction as a
// whole, by confirming_nats. Where another change of the linear part or of an effect makes the same, as both
// gains and the taper of a dead zone do, it is not listed. `model` holds the given linear part and all
// effects, given and found; `measured` its observation.
LinearChanges linear_changes(const RobotModel& model, const TrialModel& measured, const FitProblem& train,
                             const FitProblem& heldout);

// As in "the delay is longer by 54 ms (50 to 58); the gain of the left wheel is 1.03 times that of the model
// (1.02 to 1.04)".
std::string in_words(const std::vector<LinearChange>& changes, std::string_view model = "the model");

}  // namespace wheelwright::gap
