#pragma once

#include <vector>

#include "tests/benchmark/plants/run.hpp"

namespace plants::sixth {

// Size in which the runs keep off the best linear map from both commands, fitted to the runs themselves: for
// each measured quantity over several horizons. Poses count in each row.
std::vector<double> residuals(const std::vector<Run>& runs, bool ticks, bool poses);

// How large a hidden effect shows, in multiples of what the robot leaves without it: of the quantity and the
// horizon in which it is largest.
double visibility(const std::vector<double>& hidden, const std::vector<double>& clean);

}  // namespace plants::sixth
