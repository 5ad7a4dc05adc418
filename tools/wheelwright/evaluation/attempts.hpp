// All attempts of an evaluation, on as many processors as there are.
#pragma once

#include <functional>
#include <vector>

#include "tools/wheelwright/evaluation/attempt.hpp"

namespace wheelwright::tools {

// Called after each attempt with the number that is done, one call at a time, from any thread.
using Progress = std::function<void(std::size_t done)>;

// The outcomes of attempts 0 to `count` - 1, the same whatever `threads` (at least 1) is. Rethrows what an
// attempt throws.
std::vector<AttemptOutcome> run_attempts(const EvaluationPlan& plan, std::size_t count, unsigned threads,
                                         const Progress& progress = {});

}  // namespace wheelwright::tools
