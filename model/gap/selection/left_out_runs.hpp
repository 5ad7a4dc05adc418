// What a candidate gains on training runs that it was not fitted to: each predicted by the others.
#pragma once

#include <cstddef>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Sum over the runs of the gain of log likelihood, nats, by the model with one effect more, whose own
// parameters are fitted without that run (one Gauss-Newton step from the fit to all: jackknife), over
// `without`, which is fitted to all. 0 for fewer than two runs. `effect` is its index in `with`.
double left_out_runs_gain_nats(const FitProblem& problem, const Fit& without, const Fit& with,
                               std::size_t effect);

}  // namespace wheelwright::gap
