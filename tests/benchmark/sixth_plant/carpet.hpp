#pragma once

#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"

namespace plants::sixth {

// Lays the carpet where all runs of the robot without it are now and then, and together a third of the time.
void lay_carpet(Details& details, const std::vector<Run>& clean, Random& random);

}  // namespace plants::sixth
