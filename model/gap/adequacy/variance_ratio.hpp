// By how much correlation over seconds makes sums of innovations larger than the noise model says.
#pragma once

#include <span>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Variance of sums over 2 s against that of as many independent innovations, all channels together; at
// least 1.
double variance_ratio(const FitProblem& problem, std::span<const double> innovations);

}  // namespace wheelwright::gap
