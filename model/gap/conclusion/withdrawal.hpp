// When names are withdrawn that a search accepted: the runs that nothing was chosen by contradict them.
#pragma once

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

// Whether the names close nothing in untouched free runs: no figure falls by 3 % (min_fall); or the common
// fall of distance, position and heading is less, and no name is beyond doubt. The noise of a robot is never
// quite as modelled, so some tens of nats are no proof of an effect that does not show in free runs. False
// without untouched runs, or if no named effect acts in them, as a rug that they do not cross.
bool closes_nothing_untouched(const GapAnalysis& analysis);

// Whether the names explain the smaller part of what is missing: the predictive check fails, and less than
// half of the mean square of distance, position and heading in the test runs is gone (`share_gone`, of
// largest_share_gone). With a sudden effect the bound is zero instead of half: a free run that misses a
// moment or a place by little goes far astray.
bool explains_the_smaller_part(const GapAnalysis& analysis, double share_gone);

}  // namespace wheelwright::gap
