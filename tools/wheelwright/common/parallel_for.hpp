// Work on all cores of the machine.
#pragma once

#include "model/gap/fit/parallel_for.hpp"

namespace wheelwright::tools {

// Calls the job for 0 .. count-1 on as many threads as there are cores. A job may hand out further work the
// same way: whoever is idle takes some of it. What a job throws, the call throws, when all are done.
gap::ParallelFor parallel_for();

}  // namespace wheelwright::tools
