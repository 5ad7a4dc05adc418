// What a failed predictive check makes of an answer.
#pragma once

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

// `nothing_missing` becomes `unnamed`, with the sentence and the regime of the statistic that failed; beside
// names, the summary says "and something else". A passed check leaves the answer as it is.
void apply_check(GapAnalysis& analysis);

}  // namespace wheelwright::gap
