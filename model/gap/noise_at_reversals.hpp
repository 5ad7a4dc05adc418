// Noise that comes where wheels change direction. What pushes a motor and what a reading errs do not know of
// that; play, dry friction, and a gear that gives do.
#pragma once

#include <cstddef>
#include <span>

#include "model/gap/gap_problem.hpp"
#include "model/gap/trial_model.hpp"

namespace wheelwright::gap {

struct NoiseAtReversals {
  std::size_t reversals = 0;  // of single wheels, as commanded
  double times = 0.0;         // power of what is left in the 0.7 s behind the median one, over that elsewhere
  double error_span_m = 0.0;  // by which the free run's error moves there, median
  double share = 0.0;         // of what is left that lies behind reversals
  double share_of_time = 0.0;  // in which it does
};

// Of what a model leaves of the counts of these runs; all zero where no wheel changes direction.
NoiseAtReversals noise_at_reversals(const GapProblem& problem, const TrialModel& model,
                                    std::span<const double> residuals);

// Often enough, far enough above the rest, and more than counting alone makes of a smooth stop.
bool too_much_for_noise(const NoiseAtReversals& noise);

}  // namespace wheelwright::gap
