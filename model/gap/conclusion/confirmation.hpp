// The accepted model on runs that nothing was chosen by: looked at once, after the search has ended.
#pragma once

#include <vector>

#include "model/gap/adequacy/predictive_check.hpp"
#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/runs/run_set.hpp"
#include "model/gap/selection/search.hpp"

namespace wheelwright::gap {

struct Confirmation {
  PredictiveCheck check;
  // Of all effects of the accepted model: gain of log likelihood over the linear model alone, refitted,
  // divided by the variance ratio of sums over 2 s.
  double gain_nats = 0.0;
  // The same of each of its effects, in their order, over the model refitted without that one; where the runs
  // are untouched.
  std::vector<double> effect_nats;
  std::vector<bool> acts;  // whether each effect moves anything in these runs; a rug elsewhere does not
};

// `search.final` with each parameter of its effects where the runs are likeliest within its 95 % interval,
// one parameter after the other: whatever lies in there, the training runs allow. Between two commands that
// were given, a threshold may lie anywhere, and a third command in untouched runs is on one side of it.
TrialModel likeliest_within_intervals(const FitProblem& train, const GapSearch& search, const RunSet& runs,
                                      const ParallelFor& parallel_for);

// The noise is what the accepted model leaves of the training runs. Where an effect hangs on the angle of the
// wheels, each run shows that at which its wheels began: it is found first, and noted in the logs.
Confirmation confirm(const FitProblem& train, const GapSearch& search, RunSet& runs, bool untouched,
                     const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
