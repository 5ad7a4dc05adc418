// How well the parameters of a fit are known.
#pragma once

#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/fit/profile_intervals.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

// 95 % intervals of the effects' parameters, in their order. Residuals are correlated over seconds, so
// they come from a bootstrap over blocks of time (block_bootstrap.hpp), by percentiles; never narrower than
// white residuals would give; wider where the likelihood does not fall that far out (profile_intervals.hpp).
// Of a parameter whose derivatives differ from one side to the other, the likelihood alone decides.
// Where a likelier model is met in this, the fit goes on from there.
struct FitWithIntervals {
  Fit fit;
  std::vector<ParameterInterval> intervals;
};
FitWithIntervals with_effect_intervals(const FitProblem& problem, Fit fit, int steps,
                                       const ParallelFor& parallel_for);

// The same by the bootstrap alone, as deviations from the estimate, of residuals whose derivatives by the
// parameters are `columns`.
std::vector<LinearInterval> linear_intervals(const FitProblem& problem, const Eigen::MatrixXd& columns,
                                             const std::vector<double>& residuals);

}  // namespace wheelwright::gap
