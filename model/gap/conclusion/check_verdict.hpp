// What a failed predictive check makes of an answer.
#pragma once

#include <string>
#include <vector>

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

// `nothing_missing` becomes `unnamed`, with the sentence and the regime of the statistic that failed; beside
// names, the summary says "and something else". A passed check leaves the answer as it is.
void apply_check(GapAnalysis& analysis);

// Of names that are about to be withdrawn: " gain_curve would explain 48 % of the evidence.", or that they
// bring the test runs no closer.
std::string part_in_words(const GapAnalysis& analysis);

// Of names that were withdrawn beside others: " caster_kick was left out: the untouched runs do not confirm
// it."
std::string unconfirmed_in_words(const std::vector<std::string>& names);

// Of names by which nothing is seen in the test runs.
std::string not_seen_in_words(const GapAnalysis& analysis);

}  // namespace wheelwright::gap
