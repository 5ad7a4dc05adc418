// By how much a likelihood varies between neighbouring parameters without a reason.
//
// Where wheels stick and slip, or a command falls on one side of a step or the other, little changes of any
// parameter change the moments at which this happens. The sum of squared innovations is then a parabola with
// steps and bumps, and the fit that was found is the lowest bump, not the lowest point of the parabola. What
// is as likely as the truth lies above the fit by what the bumps come to.
#pragma once

#include <Eigen/Core>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// How much more than a parabola the sum of squared innovations rises over small steps from the fit, in pairs
// to both sides: the lower quartile. `columns` are the derivatives of the fit's residuals by all parameters,
// linear part first; one that is zero leaves its parameter where it is. Zero or a little more for a smooth
// likelihood. The same arguments give the same value.
double likelihood_roughness(const FitProblem& problem, const Fit& fit, const Eigen::MatrixXd& columns);

}  // namespace wheelwright::gap
