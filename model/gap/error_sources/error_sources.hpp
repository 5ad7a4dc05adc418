// Where a model is wrong: the share of the gap that falls into a regime of driving, against the share of the
// time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

struct Regime {
  std::string name;  // as a person says it: "|turn rate| > 0.4 rad/s"
  double share_of_gap = 0.0;
  double share_of_time = 0.0;
};

// `before` and `after` are residuals of the same problem under two models; the gap at a reading is what its
// square falls by. Without a better model, `after` is empty and the gap is what squares exceed the noise by.
// Regimes that hold no more of the gap than of the time are left out; the strongest first, at most `most`.
std::vector<Regime> regimes(const FitProblem& problem, const TrialModel& model,
                            std::span<const double> before, std::span<const double> after, std::size_t most);

}  // namespace wheelwright::gap
