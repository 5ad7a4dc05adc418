// Which candidate of a selection step, if any, becomes an effect of the model.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/gap/selection/model_comparison.hpp"
#include "model/gap/selection/search.hpp"

namespace wheelwright::gap {

class CandidateAcceptance {
 public:
  CandidateAcceptance(const FitProblem& train, const ModelComparison& comparison, const SearchLimits& limits,
                      const FreeRuns& free_runs)
      : train_(train), comparison_(comparison), limits_(limits), free_runs_(free_runs) {}

  // The candidate to add, after the steps `so_far`; nullptr if none is accepted. It is mostly the best one.
  // Where correlation of the residuals leaves that in doubt, one of the next two effects may be clear: it is
  // accepted if it explains something that the best one does not.
  const Candidate* next_effect(const SelectionStep& step, std::span<const SelectionStep> so_far) const;

  // Whether two effects are added at once, each of which masks the other.
  bool pair_accepted(const SelectionStep& step, std::size_t steps_so_far) const;

  // The best candidate of each effect that could be the first one, best first.
  std::vector<const Candidate*> first_effects(const SelectionStep& first) const;

 private:
  bool accepted(const Candidate& candidate, const SelectionStep& step,
                std::span<const SelectionStep> so_far) const;
  bool stands_beside(const Candidate& candidate, const Candidate& other) const;
  bool helps_what_is_off(const Candidate& candidate, const SelectionStep& step) const;
  bool explains_what_decoys_do(const Candidate& candidate, const SelectionStep& step) const;

  const FitProblem& train_;
  const ModelComparison& comparison_;
  SearchLimits limits_;
  const FreeRuns& free_runs_;
};

}  // namespace wheelwright::gap
