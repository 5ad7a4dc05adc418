// How much too large a difference of two likelihoods looks, because residuals are correlated in time.
//
// Twice the log likelihood of the better model b over the worse one w is the sum of d (2 b + d) over all
// readings, with d = w - b. Its noise comes from the sum of b d. If b were white, the variance of that sum
// would be that of d^2; the factor is the variance of its sums over blocks of time, longer than the residuals
// are correlated, divided by the sum of d^2.
#pragma once

#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// From 1 to 30. Both are residuals of the problem's readings.
double autocorrelation_factor_of(const FitProblem& problem, const std::vector<double>& worse,
                                 const std::vector<double>& better);

// The same for a gain that may be a loss.
double autocorrelation_factor_of_gain(const FitProblem& problem, double gain_nats,
                                      const std::vector<double>& without, const std::vector<double>& with);

}  // namespace wheelwright::gap
