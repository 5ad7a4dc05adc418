// Intervals of parameters by the profile of the likelihood.
//
// The derivatives at an estimate say nothing of an edge that no reading lies on, of levels between which no
// command was given, or of a knee that has no slope at zero. So each end of an interval is tried: with the
// parameter held there and the others as good as they can be, the sum of squared innovations (minus twice the
// log likelihood) must have risen by the 95 % point of chi squared (3.84), times the square of what the
// estimate scatters beyond white innovations (Pawitan, "In all likelihood", 2001, sections 2.6 and 3.4).
// Where it has not, the end lies further out.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

// What the derivatives say of one parameter.
struct LinearInterval {
  ParameterInterval deviation;   // from the estimate
  double white_deviation = 0.0;  // standard deviation if innovations were white; 0 where nothing is known
};

struct Profiles {
  std::vector<ParameterInterval> intervals;
  std::optional<TrialModel> likelier;  // met on the way: the fit was not the likeliest, by a nat or more
};

// Of the effects' parameters, in their order: the interval by derivatives, or wider. Not beyond the bounds of
// a parameter. `columns` are the derivatives of the residuals of `fit` by all parameters, linear part first,
// and so are `linear`. `roughness`: by how much the sum of squares varies from one place to the next without
// a reason (likelihood_roughness.hpp); no end is believed for less.
Profiles profile_intervals(const FitProblem& problem, const Fit& fit, const Eigen::MatrixXd& columns,
                           std::span<const LinearInterval> linear, double roughness,
                           const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
