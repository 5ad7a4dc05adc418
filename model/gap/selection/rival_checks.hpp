// What was accepted, looked at once more: would another effect do better in the place of each, now that the
// others are there, and is each of them needed?
#pragma once

#include "model/gap/selection/candidate_evaluation.hpp"
#include "model/gap/selection/search.hpp"

namespace wheelwright::gap {

class RivalChecks {
 public:
  RivalChecks(const FitProblem& train, const ModelComparison& comparison, CandidateEvaluation& evaluation,
              const SearchLimits& limits, const FreeRuns& free_runs)
      : train_(train),
        comparison_(comparison),
        evaluation_(evaluation),
        limits_(limits),
        free_runs_(free_runs) {}

  // Puts another effect in the place of one, or none, as long as the whole model gets better by it; leaves
  // the checks of what is there then.
  void swap_while_better(GapSearch& result);
  // Only looks, and leaves the checks.
  void check(GapSearch& result);
  // Takes one effect out that is not needed. False where all are; the checks must be those of the result, and
  // are not afterwards.
  bool drop_idle(GapSearch& result);

 private:
  enum class Swaps { made, only_looked_at };
  // From the first effect that has no check yet; true where the model was changed.
  bool improve_by_swaps(GapSearch& result, Swaps swaps);
  void leave_out_decoys_of_something_else(SelectionStep& check, const TrialEffect& present) const;
  void leave_out_rivals_of_something_else(SelectionStep& check, const EffectInfo* than) const;
  bool stands_for_itself(const SelectionStep& check, const EffectInfo* info, double nats,
                         double largest) const;
  bool shown_by_left_out_runs(const GapSearch& result, const Fit& without, std::size_t place) const;
  Fit in_place(const Candidate& candidate, std::size_t place) const;
  void try_in_place(SelectionStep& check, std::size_t place) const;

  const FitProblem& train_;
  const ModelComparison& comparison_;
  CandidateEvaluation& evaluation_;
  SearchLimits limits_;
  const FreeRuns& free_runs_;
};

}  // namespace wheelwright::gap
