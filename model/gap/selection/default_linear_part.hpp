// A linear part that has not seen the data: where a fit begins again, since what a linear part has taken up
// of an effect it does not give back step by step.
#pragma once

#include <array>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

constexpr std::array default_lags_s{0.03, 0.06, 0.15};

// The model with such a linear part, of two periods' delay and this lag, and with its own effects.
TrialModel with_default_linear_part(TrialModel model, double lag_s);

// Whether a linear part remembers longer than a motor can: it has taken up something else.
bool reaches_far(const TrialModel& model);

// Of some models, the one that leaves the least of the training runs.
const TrialModel& closest_to_runs(const FitProblem& train, const std::vector<TrialModel>& models,
                                  const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
