// Where a region of the floor lies and how large it is, to be tried in steps: its edges act on the few rows
// that lie across them, so that a fit follows their slope into the next best place and stays there.
#pragma once

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

bool has_region(const TrialModel& model);

// `model` with the region of its surface_patch, if it has one, moved edge by edge, shifted and turned, as a
// rectangle or an ellipse, under the robot's middle or each wheel, as long as the runs are explained better;
// all other parameters as they were.
TrialModel with_region_tuned(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for);

// The same, with discs of several sizes around it tried, too; slower.
TrialModel with_region_found(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
