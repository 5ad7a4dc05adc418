// When names are withdrawn that a search accepted: the runs that nothing was chosen by contradict them.
#pragma once

#include <string>
#include <vector>

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

// Names that untouched runs do not confirm: their log likelihood gains less than 10 by one that acts there
// (min_test_gain_nats), and held-out runs do not put it beyond doubt. In the logs of robots 13 and 14 with
// seeds 47864 and 56290, which chose it, this held for none of 303 right names and for 3 of 66 wrong ones.
std::vector<std::string> unconfirmed_names(const GapAnalysis& analysis);

// Whether the names close nothing in untouched free runs: no figure falls by 3 % (min_fall), or the common
// fall of distance, position and heading is less; and no name that the model before lacks is beyond doubt by
// the held-out runs and by these. The noise of a robot is never quite as modelled, so some tens of nats are
// no proof of an effect that does not show in free runs. False without untouched runs, or if no named effect
// acts in them, as a rug that they do not cross.
bool closes_nothing_untouched(const GapAnalysis& analysis);

// Of the evidence that the linear model is not enough, what the names explain: their gain of log likelihood
// in the test runs, g, beside the p-value of what is left, p. g / (g - ln p), between 0 and 1.
double share_of_evidence(const GapAnalysis& analysis);

// Whether the names explain the smaller part of what is missing: the predictive check fails, and either they
// explain neither nine tenths of the evidence (`sure`) nor half of a figure of `test` (largest_share_gone),
// or `test` goes further astray by them (goes_further_astray) and none is beyond doubt as above. Nine tenths
// and not half: the p-value is that of one statistic, and an effect that explains what it shows would gain
// more. Either is enough: an effect may hardly move free runs that drift, and what is left may lie in
// readings that the names do not touch.
bool explains_the_smaller_part(const GapAnalysis& analysis, const GapFigures& test);

}  // namespace wheelwright::gap
