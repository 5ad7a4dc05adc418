// Which effects are worth a fit: each is put in at some sizes, and what it changes is held against what the
// model leaves unexplained, after all that the linear part and the present effects could take up is projected
// out.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

struct Screened {
  TrialEffect start;       // where a fit begins
  double gain_nats = 0.0;  // of log likelihood, as far as a linear look can tell
};

// One size of an effect and how clearly these runs would show it.
struct Visibility {
  TrialEffect effect;
  double nats = 0.0;  // of log likelihood that leaving it out would cost
};

// Two effects that explain together what neither does alone: each one masks the other.
struct ScreenedPair {
  std::array<TrialEffect, 2> start;
  double gain_nats = 0.0;
};

struct Screening {
  std::vector<Screened> best;          // per effect and variant, best first
  std::optional<ScreenedPair> pair;    // one that explains what no single effect does
  std::vector<Visibility> visibility;  // every size of every effect that was tried
};

// `fit` is the model without the candidates, at its best. Tries each of `candidate_effects` in all its
// variants.
Screening screen(const FitProblem& problem, const Fit& fit,
                 std::span<const EffectInfo* const> candidate_effects, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
