#include "model/gap/selection/candidate_starts.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "model/gap/candidates/eccentricity_phase.hpp"
#include "model/gap/candidates/quantization_levels.hpp"
#include "model/gap/selection/default_linear_part.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_screened_nats = 4.0;
constexpr double min_screened_share = 0.08;  // of the best one's: less does not become the best by a fit

}  // namespace

std::vector<const EffectInfo*> CandidateStarts::absent_from(const TrialModel& model) const {
  std::vector<const EffectInfo*> absent;
  for (const EffectInfo* info : candidate_effects_) {
    const auto same = [info](const TrialEffect& effect) { return effect.info == info; };
    if (std::ranges::none_of(model.effects, same)) absent.push_back(info);
  }
  return absent;
}

std::optional<TrialEffect> CandidateStarts::align_wheels(
    const Fit& without, const std::vector<const EffectInfo*>& candidate_effects) {
  const auto info = std::ranges::find_if(candidate_effects, &EffectInfo::by_wheel_angle);
  if (info == candidate_effects.end()) return std::nullopt;
  const auto angles = find_eccentricity_phases(train_, heldout_, without, **info, parallel_for_);
  if (!angles) return std::nullopt;
  comparison_.set_angles_differ(angles->differ);
  train_.set_initial_travel(angles->train_rolled_m);
  heldout_.set_initial_travel(angles->heldout_rolled_m);
  return angles->start;
}

// What a linear part has taken up, it does not give back step by step: one of these effects beside a
// linear part that has not seen the data.
TrialModel CandidateStarts::beside_default_linear_part(const TrialModel& without,
                                                       const std::vector<TrialEffect>& effects,
                                                       std::span<const double> lags_s) const {
  std::vector<TrialModel> models;
  for (const double lag_s : lags_s) {
    for (const TrialEffect& effect : effects) {
      models.push_back(with_default_linear_part(without, lag_s));
      models.back().effects.push_back(effect);
    }
  }
  return closest_to_runs(train_, models, parallel_for_);
}

// Effects that hold what a linear part usually holds: a delay, two lags.
std::vector<TrialModel> CandidateStarts::instead_of_linear_part(
    const TrialModel& without, const std::vector<const EffectInfo*>& candidate_effects) const {
  constexpr std::array nothing_beside_s{0.01};
  std::vector<TrialModel> models;
  for (const EffectInfo* info : candidate_effects) {
    std::vector<TrialEffect> effects;
    if (info->linear) {
      for (const double size : info->parameters.front().sizes) effects.push_back({info, 0, {size}});
      models.push_back(beside_default_linear_part(without, effects, default_lags_s));
    } else if (info->name == "asymmetric_response") {
      for (const double extra_lag_s : {-0.1, -0.04, 0.05, 0.15}) {
        for (const double quick_lag_s : {0.04, 0.1}) effects.push_back({info, 1, {extra_lag_s, quick_lag_s}});
      }
      models.push_back(beside_default_linear_part(without, effects, nothing_beside_s));
    }
  }
  return models;
}

// A step is looked for again only beside more effects than before, which may have hidden it.
std::optional<TrialEffect> CandidateStarts::steps_beside(const Fit& without, const EffectInfo& info) {
  if (!steps_beside_ || without.model.effects.size() > *steps_beside_) {
    steps_beside_ = without.model.effects.size();
    steps_ = find_command_steps(train_, without, info, parallel_for_);
  }
  return steps_;
}

// First what has a search of its own, then by screening.
CandidateStarts::Promising CandidateStarts::promising(const Fit& without, std::size_t fits_already) {
  std::vector<TrialEffect> effects;
  const std::vector<const EffectInfo*> absent = absent_from(without.model);
  if (const auto rippling = align_wheels(without, absent)) effects.push_back(*rippling);
  const auto stepping = std::ranges::find(absent, "command_quantization", &EffectInfo::name);
  if (stepping != absent.end()) {
    if (const auto steps = steps_beside(without, **stepping)) effects.push_back(*steps);
  }
  const Screening screening = screen(train_, without, absent, parallel_for_);
  for (const auto& screened : screening.best) {
    if (fits_already + effects.size() >= limits_.max_fits || screened.gain_nats < min_screened_nats) break;
    if (screened.gain_nats < min_screened_share * screening.best.front().gain_nats) break;
    effects.push_back(screened.start);
  }
  return {std::move(effects), screening.pair};
}

CandidateStarts::Models CandidateStarts::beside(const Fit& without,
                                                const std::vector<TrialModel>& more_models) {
  const auto [effects, pair] = promising(without, more_models.size());
  Models all;
  all.singles = more_models;
  std::ranges::move(instead_of_linear_part(without.model, absent_from(without.model)),
                    std::back_inserter(all.singles));
  const bool far = reaches_far(without.model);
  for (const auto& effect : effects) {
    all.singles.push_back(without.model);
    all.singles.back().effects.push_back(effect);
    if (far) all.singles.push_back(beside_default_linear_part(without.model, {effect}, default_lags_s));
  }
  if (pair) {
    all.pair = without.model;
    std::ranges::copy(pair->start, std::back_inserter(all.pair->effects));
  }
  return all;
}

}  // namespace wheelwright::gap
