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

// Robots of which nothing is missing wander by 7 mm and 9 mrad at most, real Creates by 14 mm under a model
// that lacks something.
constexpr Wandering largest_noise{0.015, 0.025};
bool beyond_noise(const Wandering& by, double times = 1.0);
// The same noise, wandering by no more than that.
NoiseModel no_more_than_noise(const NoiseModel& noise);

// Whether what is left, which hangs together, is more than what was found explains, or has the robot wander
// as noise does not (`left`). Where a moment or a place decides, it may: little is wrong, and much of the run
// with it.
bool is_the_smaller_part(const GapAnalysis& analysis, const Wandering& left);

}  // namespace wheelwright::gap
