// Thresholds that a command or a drive has to pass before a wheel moves. Whether it passes is yes or no, and
// much of a run hangs on it, so that there is no slope for a fit to follow, and many places are tried.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Whether an effect has such a threshold.
bool has_threshold(const EffectInfo& info);

// `model` with the thresholds of its effects, if any, where its free runs are best: of dead_zone between any
// two commands that were given, as it is and as a step, of stiction up to a third away.
TrialModel with_thresholds_tuned(const FitProblem& train, TrialModel model);

}  // namespace wheelwright::gap
