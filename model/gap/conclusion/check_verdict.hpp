// What a failed predictive check makes of an answer.
#pragma once

#include <string>

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

// `nothing_missing` becomes `unnamed`, with the sentence and the regime of the statistic that failed; beside
// names, the summary says "and something else". A passed check leaves the answer as it is.
void apply_check(GapAnalysis& analysis);

// Of names that are about to be taken back, as in " gain_curve explains 48 % of it."; empty where they
// explain nothing.
std::string part_in_words(const GapAnalysis& analysis);

}  // namespace wheelwright::gap
