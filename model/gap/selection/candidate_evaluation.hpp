// Evaluates all effects that could be added to a model.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/selection/candidate_starts.hpp"

namespace wheelwright::gap {

constexpr int steps_of_a_fit = 10;
constexpr std::size_t max_costly_candidates = 3;  // of the best, where to evaluate each again is costly
constexpr int steps_of_a_refit = 5;

class CandidateEvaluation {
 public:
  // `candidate_effects` are those that the data can show at all, decoys among them.
  CandidateEvaluation(FitProblem& train, FitProblem& heldout, ModelComparison& comparison,
                      std::span<const EffectInfo* const> candidate_effects, const SearchLimits& limits,
                      ParallelFor parallel_for)
      : train_(train),
        heldout_(heldout),
        comparison_(comparison),
        limits_(limits),
        parallel_for_(std::move(parallel_for)),
        starts_(train, heldout, comparison, candidate_effects, limits, parallel_for_) {}

  // Noise is what the model leaves; it holds from here on.
  void set_noise_left_by(const TrialModel& model);
  // Fit and noise depend on each other: both, as often as asked for.
  Fit settle(TrialModel model, int passes);

  // 1. Screens all effects that the model does not hold.
  // 2. Fits the most promising ones beside the linear part and judges them; `more_models`, each with one
  //    effect more than `without`, in any case, and two effects at once where each masks the other.
  // 3. Estimates the noise with the best candidate in the model: without it, the noise absorbs the missing
  //    effect. Where several are nearly as good, with the likeliest, each under the noise that it leaves.
  // 4. Fits all again under that noise.
  SelectionStep evaluate(const Fit& without, const std::vector<TrialModel>& more_models = {});

  // What hides each other explains little one by one, and the noise that both together leave is smaller than
  // that which one leaves: the best few that help at all are fitted two by two, each two under their own
  // noise. The likeliest two are the pair of the step where they stand out under it, and their noise stays.
  void pair_the_best(SelectionStep& selection_step);

  // The same effects beside a linear part that was found again, where that explains more: what a linear part
  // had taken up of an effect that has come in since, it does not give back step by step.
  Fit with_refitted_linear_part(const Fit& fit);

  std::vector<const EffectInfo*> absent_from(const TrialModel& model) const {
    return starts_.absent_from(model);
  }

 private:
  TrialModel tuned(const TrialModel& model) const;
  using RegionSearch = TrialModel (*)(const FitProblem&, TrialModel, const ParallelFor&);
  void place_regions(SelectionStep& selection_step, int steps, RegionSearch placed) const;
  void shape_forks(SelectionStep& selection_step, int steps) const;
  std::vector<const Candidate*> helpful(const SelectionStep& selection_step) const;
  double own_log_likelihood(Fit& fit, std::size_t effects) const;
  TrialModel likeliest_under_its_own_noise(const SelectionStep& selection_step) const;
  bool stands_out_of_its_own_noise(const SelectionStep& selection_step);
  bool pair_stands_out_of_its_own_noise(const SelectionStep& selection_step);
  Fit with_linear_part_of(const Fit& without, const TrialModel& candidate) const;
  void start_from_linear_part_of(const TrialModel& without, std::vector<Candidate>& candidates) const;
  Outputs affected_outputs_of_last(const TrialModel& model, std::size_t effects) const;

  FitProblem& train_;
  FitProblem& heldout_;
  ModelComparison& comparison_;
  SearchLimits limits_;
  ParallelFor parallel_for_;
  CandidateStarts starts_;
};

// The best candidate that has a name; nothing where only decoys were left.
const Candidate* best_named(const SelectionStep& selection_step);

}  // namespace wheelwright::gap
