// One look at a model: which effects could be added to it, and how well each one would do.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/candidates/screening.hpp"
#include "model/gap/selection/model_comparison.hpp"

namespace wheelwright::gap {

constexpr int steps_of_a_fit = 10;
constexpr int steps_of_a_refit = 5;

class GapLook {
 public:
  // `candidates` are the effects that the data can show at all, decoys among them.
  GapLook(GapProblem& train, GapProblem& heldout, Contest& contest,
          std::span<const EffectInfo* const> candidates, const SearchLimits& limits, ForEach for_each)
      : train_(train),
        heldout_(heldout),
        contest_(contest),
        candidates_(candidates.begin(), candidates.end()),
        limits_(limits),
        for_each_(std::move(for_each)) {}

  // Noise is what the model leaves; it holds from here on.
  void set_noise_left_by(const TrialModel& model);
  // Fit and noise depend on each other: both, as often as asked for.
  GapFit settle(TrialModel model, int passes);

  // Screens all that the model does not hold, fits the most promising ones beside the core and judges them.
  // `more_models`, each with one effect more than `without`, are tried in any case, and two effects at once
  // where each masks the other. The noise is then what the best one leaves, since before, it holds what is
  // missing; and all are fitted again under it.
  Round look(const GapFit& without, const std::vector<TrialModel>& more_models = {});

  // The same effects beside a core that was found anew, where that explains more: what a core had taken up of
  // an effect that has come in since, it does not give back step by step.
  GapFit with_core_afresh(const GapFit& fit);

  std::vector<const EffectInfo*> absent_from(const TrialModel& model) const;

 private:
  const TrialModel& closest(const std::vector<TrialModel>& models) const;
  TrialModel beside_bare_core(const TrialModel& without, const std::vector<TrialEffect>& effects,
                              std::span<const double> lags_s) const;
  std::vector<TrialModel> instead_of_core(const TrialModel& without,
                                          const std::vector<const EffectInfo*>& candidates) const;
  std::optional<TrialEffect> align_wheels(const GapFit& without,
                                          const std::vector<const EffectInfo*>& candidates);
  std::optional<TrialEffect> steps_beside(const GapFit& without, const EffectInfo& info);
  struct Starts {
    std::vector<TrialModel> singles;
    std::optional<TrialModel> pair;
  };
  Starts starts(const GapFit& without, const std::vector<TrialModel>& more_models);
  TrialModel tuned(const TrialModel& model) const;
  using RegionSearch = TrialModel (*)(const GapProblem&, TrialModel, const ForEach&);
  void place_regions(Round& round, int steps, RegionSearch placed) const;
  bool stands_out_of_its_own_noise(const Round& round);
  bool pair_stands_out_of_its_own_noise(const Round& round);
  GapFit with_core_of(const GapFit& without, const TrialModel& contender) const;
  void start_from_core_of(const TrialModel& without, std::vector<Contender>& contenders) const;
  Part part_of_last(const TrialModel& model, std::size_t effects) const;

  GapProblem& train_;
  GapProblem& heldout_;
  Contest& contest_;
  std::vector<const EffectInfo*> candidates_;
  SearchLimits limits_;
  ForEach for_each_;
  std::optional<TrialEffect> steps_;  // in which commands seem to act
  std::optional<std::size_t> steps_beside_;
};

// The best contender that has a name; nothing where only decoys were left.
const Contender* best_named(const Round& round);

}  // namespace wheelwright::gap
