// Whether the names that a search came to stand: what free runs, decoys and what is left say of them.
#pragma once

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/figures/free_run_figures.hpp"

namespace wheelwright::gap {

constexpr double sure = 0.9;                 // posterior from which on a name stands
constexpr double beyond_doubt_nats = 100.0;  // held out, where no figure lies above the noise

// What the model found leaves, in floors of the figures as they stand.
Excess what_is_left(const GapAnalysis& analysis);

// Whether what was found shows where a person looks: some figure of the held-out free runs falls by it; or it
// is beyond doubt. Linear effects alone have to show, and so has what stands in for one that was left out
// (`linear_left_out`).
bool closes_the_gap(const GapAnalysis& analysis, bool linear_left_out);

// Whether one effect at least, of those that are sure, explains more of held-out runs than chance is
// believed to.
bool is_beyond_chance(const GapAnalysis& analysis);

// Of a random walk within a second: sound robots drift by 7 mm and 9 mrad at most, real Creates by 14 mm
// under a model that lacks something.
constexpr double largest_drift_m_per_sqrt_s = 0.015;
constexpr double largest_drift_rad_per_sqrt_s = 0.025;
// The same noise, drifting by no more than that.
NoiseModel no_more_than_noise(const NoiseModel& noise);

// Whether the names have to be withdrawn for what untouched free runs show: no figure of them falls by 3 %
// (min_fall); or distance, position and heading together do not, and no name is beyond doubt. False where no
// named effect acts in these runs, as a rug that they do not drive over. The noise of a robot is never quite
// as modelled, so some tens of nats are no proof that a free run does not show.
bool closes_nothing_untouched(const GapAnalysis& analysis);

// Whether the names are not what is missing: the predictive check fails, and of the mean square of distance,
// position and heading in the test runs less than half is gone by them; none, where an effect is sudden,
// since a free run that misses a moment or a place by little goes far astray.
bool explains_the_smaller_part(const GapAnalysis& analysis);

}  // namespace wheelwright::gap
