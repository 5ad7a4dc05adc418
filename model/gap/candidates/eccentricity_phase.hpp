// At which angle each run's wheels began to turn, and how far they roll in one turn.
//
// A wheel that is not round ripples with its angle, but nobody notes at which angle it stood when a run was
// started: without that, the ripples of several runs cancel out in a fit. So each run's residuals are laid
// against sine and cosine of its own wheels' travel, for every circumference a wheel might have. Counts that
// go on from run to run tell the angle: then one angle serves all.
#pragma once

#include <optional>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

struct WheelAngles {
  TrialEffect start;                      // of the fit: sizes and circumference
  std::vector<WheelPair> train_rolled_m;  // before each run; by its first counts where one angle serves all
  std::vector<WheelPair> heldout_rolled_m;
  bool differ = false;  // each run has angles of its own: two more numbers for each run
};

// `info` is the effect that hangs on the angle. Nothing where no ripple stands out in the residuals of the
// fit.
std::optional<WheelAngles> find_eccentricity_phases(const FitProblem& train, const FitProblem& heldout,
                                                    const Fit& fit, const EffectInfo& info,
                                                    const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
