// Parameters that a fit has left where nothing depends on them any more: a knee that is sharper than a
// simulation can tell has no slope that would lead away from it.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// `fit`, or a likelier one that begins with such a parameter at a size of its own.
Fit away_from_flat_parameters(const FitProblem& train, const Fit& fit, int steps);

}  // namespace wheelwright::gap
