// How well the parameters of a fit are known.
#pragma once

#include <vector>

#include "model/gap/gap_problem.hpp"
#include "model/robot_model.hpp"

namespace wheelwright::gap {

// 95 % intervals of all parameters, core first. What is left hangs together over seconds, so the spread is
// taken from sums over blocks of time (the sandwich of Huber and White over blocks; for long runs the same as
// resampling the blocks), and never smaller than white residuals would give.
std::vector<ParameterInterval> parameter_intervals(const GapProblem& problem, const GapFit& fit);

}  // namespace wheelwright::gap
