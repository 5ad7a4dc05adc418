// Whether the names that a search ended with are given: they have to bring free runs of the held-out runs
// closer, or to gain enough likelihood there. Also how far noise may drift before it counts as a gap.
// conclusion/withdrawal.hpp decides by the untouched runs afterwards.
#pragma once

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/figures/free_run_figures.hpp"

namespace wheelwright::gap {

constexpr double sure_posterior = 0.9;       // posterior from which on a name stands
constexpr double beyond_doubt_nats = 100.0;  // of held-out runs: enough even if no figure is above the noise

// Whether a name stands and explains more than `nats` of held-out runs.
bool is_sure_by(const Finding& found, double nats);

// How far the figures of the model found are above their noise floors.
Excess residual_excess(const GapAnalysis& analysis);

// Whether a delay that no linear part could hold is beyond doubt on held-out runs. Under commands that change
// slowly, free runs hardly show it, and a linear part of high order answers nearly as late.
bool has_long_delay_beyond_doubt(const GapAnalysis& analysis);

// Whether the effects found show in the figures of the held-out free runs, or are beyond doubt. Linear
// effects alone have to show, but for a long delay beyond doubt. Nonlinear effects have to as well if a
// linear one was rejected in their favour (`linear_left_out`). Where the free runs are off by less than
// anybody sees, one of the effects has to be beyond chance.
bool closes_the_gap(const GapAnalysis& analysis, bool linear_left_out);

// Whether at least one sure effect explains more of held-out runs than chance does.
bool is_beyond_chance(const GapAnalysis& analysis);

// Largest random walk within a second that counts as noise: sound robots drift by 7 mm and 9 mrad at most,
// real Creates by 14 mm under a model that lacks something.
constexpr double largest_drift_m_per_sqrt_s = 0.015;
constexpr double largest_drift_rad_per_sqrt_s = 0.025;
// The same noise, with drifts cut to these.
NoiseModel with_bounded_drift(const NoiseModel& noise);

}  // namespace wheelwright::gap
