// Finds the effects that a linear model of these runs lacks: candidates are screened, fitted together with
// the linear part, judged on runs that were held out, and put in one after the other, with swaps, since
// effects mask each other. Where several could be the first, the search goes on from each of them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/candidates/screening.hpp"
#include "model/gap/fit/parameter_intervals.hpp"
#include "model/gap/selection/model_comparison.hpp"

namespace wheelwright::gap {

struct GapSearch {
  Fit baseline;                              // the linear model alone, under the final noise
  Fit final;                                 // with all that was accepted, in the order in which it was found
  std::vector<ParameterInterval> intervals;  // of the parameters of its effects, 95 %
  std::vector<SelectionStep> selection_steps;  // in the order of the search; the last one ended it
  // For each accepted effect: the model without it, and who would take its place.
  std::vector<SelectionStep> checks;
  std::vector<WheelPair> train_rolled_m;  // what was found of where each run's wheels stood at its start
  std::vector<WheelPair> heldout_rolled_m;
  Screening last_look;  // from `final`: what is absent, and how clearly it would have shown
  double heldout_sum_squares_before = 0.0;
  double heldout_sum_squares_after = 0.0;
};

// Called before each longer piece of work with a word for it and the share done.
using Progress = std::function<void(const std::string& what, double share)>;

// What a search asks of the free runs.
struct FreeRuns {
  // Whether those of a model are off by more than noise explains: then a further effect may be small beside
  // the first one.
  std::function<bool(const TrialModel& model)> still_off;
  // Whether those that were held out come closer by what one model has and the other has not.
  std::function<bool(const TrialModel& without, const TrialModel& with)> closer;
};

// `candidate_effects` are those that the data can show at all, decoys among them.
GapSearch search_gap(FitProblem& train, FitProblem& heldout, const TrialModel& start,
                     std::span<const EffectInfo* const> candidate_effects, const SearchLimits& limits,
                     const FreeRuns& free_runs, const ParallelFor& parallel_for, const Progress& progress);

}  // namespace wheelwright::gap
