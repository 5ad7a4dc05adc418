// The sizes, shapes and places at which each effect is tried before any fit.
#pragma once

#include <span>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Several parameters of an effect act together, in proportion (sine and cosine, x and y): they are looked at
// at once.
struct Probe {
  const EffectInfo* info;
  std::size_t variant;
  std::vector<std::vector<double>> points;  // parameter vectors; more than one for effects of several sizes
};

// Of each of `candidate_effects`, in all its variants that these runs could tell apart. Regions of the floor
// are tried where the robot has been.
std::vector<Probe> probes_of(std::span<const EffectInfo* const> candidate_effects, const FitProblem& problem,
                             const TrialModel& model);

}  // namespace wheelwright::gap
