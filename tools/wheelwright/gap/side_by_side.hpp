// Work on all cores of the machine.
#pragma once

#include "model/gap/gap_problem.hpp"

namespace wheelwright::tools {

// Calls the job for 0 .. count-1 on as many threads as there are cores; inside a job, further work goes in
// turn.
gap::ForEach side_by_side();

}  // namespace wheelwright::tools
