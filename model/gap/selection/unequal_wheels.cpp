#include "model/gap/selection/unequal_wheels.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/threshold_search.hpp"
#include "model/gap/selection/candidate_evaluation.hpp"

namespace wheelwright::gap {
namespace {

// The model whose last effect has a size for each wheel, or their mean for both where it has one for each;
// nothing where there is no such variant.
std::optional<TrialModel> otherwise_sized(TrialModel model) {
  TrialEffect& last = model.effects.back();
  const EffectSetting setting{last.info->name, last.info->variants[last.variant].name, last.parameters};
  EffectSetting other = of_each_wheel(setting);
  if (is_of_each_wheel(setting)) {
    other = as_at(WheelSide::left, setting);
    const std::vector<double> right = as_at(WheelSide::right, setting).parameters;
    for (std::size_t i = 0; i < right.size(); ++i)
      other.parameters[i] = 0.5 * (other.parameters[i] + right[i]);
  }
  if (other.variant == setting.variant) return std::nullopt;
  last.variant = variant_index(*last.info, other.variant);
  last.parameters = other.parameters;
  return model;
}

Fit fit_of(const FitProblem& train, const TrialModel& model) {
  const Outputs outputs = train.outputs_of(model.effects.back());
  Fit fit = train.fit(model, steps_of_a_fit, outputs);
  if (!has_threshold(*model.effects.back().info)) return fit;
  return train.fit(with_thresholds_tuned(train, fit.model), steps_of_a_refit, outputs);
}

}  // namespace

void size_each_wheel(const FitProblem& train, const ModelComparison& comparison, const SearchLimits& limits,
                     SelectionStep& selection_step, const ParallelFor& parallel_for) {
  auto& candidates = selection_step.candidates;
  std::vector<std::pair<Candidate*, std::optional<Fit>>> tried;
  for (Candidate& candidate : candidates) {
    if (tried.size() == max_costly_candidates || candidate.score <= 0.0) break;
    const bool known = std::ranges::any_of(tried, [&](const auto& other) {
      return other.first->effect.info == candidate.effect.info &&
             other.first->effect.variant == candidate.effect.variant;
    });
    if (!known && candidate.behind == 0) tried.emplace_back(&candidate, std::nullopt);
  }
  parallel_for(tried.size(), [&](std::size_t i) {
    auto& [candidate, other] = tried[i];
    const auto model = otherwise_sized(candidate->fit.model);
    if (model) other = fit_of(train, *model);
  });
  bool any = false;
  for (auto& [candidate, other] : tried) {
    if (!other) continue;
    const TrialEffect& last = other->model.effects.back();
    const bool wheels_are_alike = !last.info->variants[last.variant].alike;
    const double advantage = comparison.advantage(*other, candidate->fit);
    if (advantage < (wheels_are_alike ? -limits.min_heldout_nats : limits.min_heldout_nats)) continue;
    candidate->fit = std::move(*other);
    any = true;
  }
  if (any) comparison.judge(selection_step);
}

}  // namespace wheelwright::gap
