// Parameters that a fit has left at a bound where nothing depends on them any more: a knee of zero has no
// slope that would lead away from it.
#pragma once

#include "model/gap/fit/problem.hpp"

namespace wheelwright::gap {

// `fit`, or a likelier one that begins with such a parameter at a size of its own.
GapFit away_from_flat_bounds(const GapProblem& train, const GapFit& fit, int steps);

}  // namespace wheelwright::gap
