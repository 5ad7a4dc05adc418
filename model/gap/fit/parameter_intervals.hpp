// How well the parameters of a fit are known.
#pragma once

#include <vector>

#include "model/gap/fit/problem.hpp"
#include "model/robot_model.hpp"

namespace wheelwright::gap {

// 95 % intervals of all parameters, core first. What is left hangs together over seconds, so they come from a
// bootstrap over blocks of time (model/gap/block_bootstrap.hpp), by percentiles; never narrower than white
// residuals would give, and within the bounds of the parameter.
std::vector<ParameterInterval> parameter_intervals(const GapProblem& problem, const GapFit& fit);

// The same as deviations from the estimate, for residuals whose derivatives by the parameters are `columns`.
std::vector<ParameterInterval> deviation_intervals(const GapProblem& problem, const Eigen::MatrixXd& columns,
                                                   const std::vector<double>& residuals);

}  // namespace wheelwright::gap
