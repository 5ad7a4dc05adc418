// How large the regions are that a search tries: of a floor that is larger than a room's, larger ones.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// The longer side of the rectangle that the references of all runs lie in, over 2.5 m; at least 1. Sizes,
// distances and steps of a search in a room are multiplied by it.
double region_scale(const FitProblem& problem);

}  // namespace wheelwright::gap
