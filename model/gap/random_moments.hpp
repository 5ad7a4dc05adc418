// What happens now and then, at no time that anything foretells: a contact that fails, a link that loses
// commands, a wheel that slips or is held for a moment. A model without it calls it noise, since free runs
// are off no further than such noise makes them; but noise is there all the time.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/gap_problem.hpp"
#include "model/gap/trial_model.hpp"

namespace wheelwright::gap {

struct RandomMoments {
  struct Moment {
    std::string run;
    double time_s = 0.0;  // as in the log
  };
  std::vector<Moment> moments;  // the strongest first
  double share = 0.0;           // of what the model leaves
  double share_of_time = 0.0;   // in which it does
};

// Such moments in what a model leaves of these runs: not a fiftieth of the time, but half of the power, of
// the wheels' travel or of the body's; each of some millimetres. Nothing where the power is spread.
std::optional<RandomMoments> random_moments(const GapProblem& problem, const TrialModel& model,
                                            std::span<const double> residuals);

}  // namespace wheelwright::gap
