// Wheels that are not alike: two motors and gears seldom are.
#pragma once

#include "model/gap/selection/model_comparison.hpp"

namespace wheelwright::gap {

// Fits the few best candidates of a step again, with a size for each wheel where their effect has one for
// both, and keeps that where its likelihood on training and held-out runs leaves no doubt that the wheels
// differ; and with one size for both where it has one for each without such proof. Judges the step again
// then.
void size_each_wheel(const FitProblem& train, const ModelComparison& comparison, const SearchLimits& limits,
                     SelectionStep& selection_step, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
