// Work on all cores of the machine.
#pragma once

#include "model/gap/fit/problem.hpp"

namespace wheelwright::tools {

// Calls the job for 0 .. count-1 on as many threads as there are cores. A job may hand out further work the
// same way: whoever is idle takes some of it. What a job throws, the call throws, when all are done.
gap::ForEach side_by_side();

}  // namespace wheelwright::tools
