// What shape a caster's fork has, drawn: to which side it swings at a flip hangs on where it stood before,
// and so on the whole way up to there. A fit goes down into the nearest of many pits and stays in it.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Whether the effect knows the shape of a fork, and not only that it kicks.
bool has_fork(const TrialEffect& effect);

// `model`, whose last effect has a fork, with the likeliest of many in its place, as strong as it explains
// most. The best few are fitted a little, and so is that of the model itself, which stays if it is the
// likeliest.
TrialModel with_fork_found(const FitProblem& train, const TrialModel& model, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
