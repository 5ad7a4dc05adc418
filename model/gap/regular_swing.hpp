// What keeps a beat: a hum, a speed loop that hunts, a gear whose teeth are felt. No effect of the library
// swings at a period of its own, so where nothing has a name, such a beat is what is missing.
#pragma once

#include <optional>
#include <span>

#include "model/gap/gap_problem.hpp"
#include "model/gap/trial_model.hpp"

namespace wheelwright::gap {

struct RegularSwing {
  enum class Over { time, way } over = Over::time;  // way: of a wheel, by its counts
  double period = 0.0;                              // s or m
  double share = 0.0;                               // of what the model leaves
};

// The strongest swing in what a model leaves of these runs, from 0.125 s or 12 mm up to a quarter of the run.
// It must hold a twentieth of the power, stand out of its neighbourhood, so that coloured noise is none, and
// be larger than what rounding to counts makes of a steady speed.
std::optional<RegularSwing> regular_swing(const GapProblem& problem, const TrialModel& model,
                                          std::span<const double> residuals);

}  // namespace wheelwright::gap
