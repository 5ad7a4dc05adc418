// Where the fits of a round begin: what screening finds worth a fit, and what no slope leads to.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/candidates/screening.hpp"
#include "model/gap/selection/model_comparison.hpp"

namespace wheelwright::gap {

class CandidateStarts {
 public:
  // `candidate_effects` are those that the data can show at all, decoys among them.
  CandidateStarts(FitProblem& train, FitProblem& heldout, ModelComparison& comparison,
                  std::span<const EffectInfo* const> candidate_effects, const SearchLimits& limits,
                  ParallelFor parallel_for)
      : train_(train),
        heldout_(heldout),
        comparison_(comparison),
        candidate_effects_(candidate_effects.begin(), candidate_effects.end()),
        limits_(limits),
        parallel_for_(std::move(parallel_for)) {}

  std::vector<const EffectInfo*> absent_from(const TrialModel& model) const;

  struct Models {
    std::vector<TrialModel> singles;  // with one effect more than `without`
    std::optional<TrialModel> pair;   // with two that mask each other
  };
  // `more_models`, each with one effect more than `without`, come first. Sets where the wheels of each run
  // stood at its start, if an effect of their angle shows.
  Models beside(const Fit& without, const std::vector<TrialModel>& more_models);

 private:
  TrialModel beside_default_linear_part(const TrialModel& without, const std::vector<TrialEffect>& effects,
                                        std::span<const double> lags_s) const;
  std::vector<TrialModel> instead_of_linear_part(
      const TrialModel& without, const std::vector<const EffectInfo*>& candidate_effects) const;
  std::optional<TrialEffect> align_wheels(const Fit& without,
                                          const std::vector<const EffectInfo*>& candidate_effects);
  std::optional<TrialEffect> steps_beside(const Fit& without, const EffectInfo& info);
  struct Promising {
    std::vector<TrialEffect> effects;  // no more than there may be fits
    std::optional<ScreenedPair> pair;
  };
  Promising promising(const Fit& without, std::size_t fits_already);

  FitProblem& train_;
  FitProblem& heldout_;
  ModelComparison& comparison_;
  std::vector<const EffectInfo*> candidate_effects_;
  SearchLimits limits_;
  ParallelFor parallel_for_;
  std::optional<TrialEffect> steps_;  // in which commands seem to act
  std::optional<std::size_t> steps_beside_;
};

}  // namespace wheelwright::gap
