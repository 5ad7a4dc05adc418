// The steps in which commands act, to within the commands that were given: a command close to a rise goes up
// or not, so that there is no slope for a fit to follow, and every place is tried.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Whether the effect is command_quantization.
bool rounds_commands(const EffectInfo& info);

// `model` with its command_quantization, if it has one, where its free runs are best.
TrialModel with_steps_tuned(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for);

// `model` with its command_quantization, if it has one, in the middle of all that explain these runs as well:
// between two commands that were given, a rise may lie anywhere.
TrialModel with_steps_centred(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
