#include "model/gap/selection/candidate_evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/eccentricity_phase.hpp"
#include "model/gap/candidates/quantization_levels.hpp"
#include "model/gap/candidates/quantization_search.hpp"
#include "model/gap/candidates/region_search.hpp"
#include "model/gap/candidates/threshold_search.hpp"

namespace wheelwright::gap {
namespace {

constexpr double least_screened_nats = 4.0;
constexpr double least_screened_share = 0.08;  // of the best one's: less does not become the best by a fit
constexpr std::array usual_lags_s{0.03, 0.06, 0.15};

// A core that remembers longer than a motor can has taken up something else.
bool reaches_far(const TrialModel& model) {
  constexpr double longest_lag_s = 0.5;
  const LinearModel core = model.linear();
  return std::max(largest_pole(core.left), largest_pole(core.right)) >
         std::exp(-model.period_s / longest_lag_s);
}

TrialModel with_bare_core(TrialModel model, double lag_s) {
  const double delay_s = 2.0 * model.period_s;
  model.core = first_guess(model.shape, model.period_s, model.wheel_base_m, lag_s, delay_s).core;
  return model;
}

}  // namespace

void GapLook::set_noise_left_by(const TrialModel& model) {
  const NoiseModel noise = train_.noise_left_by(model);
  train_.set_noise(noise);
  heldout_.set_noise(noise);
}

// What no slope leads to.
TrialModel GapLook::tuned(const TrialModel& model) const {
  const TrialModel stepping = with_thresholds_tuned(train_, with_steps_tuned(train_, model, for_each_));
  return with_region_tuned(train_, stepping, for_each_);
}

GapFit GapLook::settle(TrialModel model, int passes) {
  GapFit fit;
  for (int pass = 0; pass < passes; ++pass) {
    set_noise_left_by(model);
    fit = train_.fit(tuned(model), steps_of_a_fit);
    model = fit.model;
  }
  return fit;
}

std::vector<const EffectInfo*> GapLook::absent_from(const TrialModel& model) const {
  std::vector<const EffectInfo*> absent;
  for (const EffectInfo* info : candidates_) {
    const auto same = [info](const TrialEffect& effect) { return effect.info == info; };
    if (std::ranges::none_of(model.effects, same)) absent.push_back(info);
  }
  return absent;
}

std::optional<TrialEffect> GapLook::align_wheels(const GapFit& without,
                                                 const std::vector<const EffectInfo*>& candidates) {
  const auto info = std::ranges::find_if(candidates, &EffectInfo::by_wheel_angle);
  if (info == candidates.end()) return std::nullopt;
  const auto angles = find_wheel_angles(train_, heldout_, without, **info, for_each_);
  if (!angles) return std::nullopt;
  contest_.set_angles_differ(angles->differ);
  train_.set_rolled_before(angles->train_rolled_m);
  heldout_.set_rolled_before(angles->heldout_rolled_m);
  return angles->start;
}

const TrialModel& GapLook::closest(const std::vector<TrialModel>& models) const {
  std::vector<double> squares(models.size());
  for_each_(models.size(), [&](std::size_t i) { squares[i] = squares_of(train_.residuals(models[i])); });
  return models[static_cast<std::size_t>(std::ranges::min_element(squares) - squares.begin())];
}

GapFit GapLook::with_core_afresh(const GapFit& fit) {
  std::vector<TrialModel> models;
  models.reserve(usual_lags_s.size());
  for (const double lag_s : usual_lags_s) models.push_back(with_bare_core(fit.model, lag_s));
  constexpr double within_reach = 1.05;  // of the squares
  GapFit afresh = train_.fit(closest(models), steps_of_a_fit);
  if (afresh.squares > within_reach * fit.squares) return fit;
  afresh = train_.fit(afresh.model, steps_of_a_fit);
  return afresh.squares < fit.squares ? afresh : fit;
}

// What a linear core has taken up, it does not give back step by step: one of these effects beside a core
// that has not seen the data.
TrialModel GapLook::beside_bare_core(const TrialModel& without, const std::vector<TrialEffect>& effects,
                                     std::span<const double> lags_s) const {
  std::vector<TrialModel> models;
  for (const double lag_s : lags_s) {
    for (const TrialEffect& effect : effects) {
      models.push_back(with_bare_core(without, lag_s));
      models.back().effects.push_back(effect);
    }
  }
  return closest(models);
}

// Effects that hold what a core usually holds: a delay, two lags.
std::vector<TrialModel> GapLook::instead_of_core(const TrialModel& without,
                                                 const std::vector<const EffectInfo*>& candidates) const {
  constexpr std::array nothing_beside_s{0.01};
  std::vector<TrialModel> models;
  for (const EffectInfo* info : candidates) {
    std::vector<TrialEffect> effects;
    if (info->linear) {
      for (const double size : info->parameters.front().sizes) effects.push_back({info, 0, {size}});
      models.push_back(beside_bare_core(without, effects, usual_lags_s));
    } else if (info->name == "asymmetric_response") {
      for (const double extra_lag_s : {-0.1, -0.04, 0.05, 0.15}) {
        for (const double quick_lag_s : {0.04, 0.1}) effects.push_back({info, 1, {extra_lag_s, quick_lag_s}});
      }
      models.push_back(beside_bare_core(without, effects, nothing_beside_s));
    }
  }
  return models;
}

// A step is looked for anew only beside more effects than before, which may have hidden it.
std::optional<TrialEffect> GapLook::steps_beside(const GapFit& without, const EffectInfo& info) {
  if (!steps_beside_ || without.model.effects.size() > *steps_beside_) {
    steps_beside_ = without.model.effects.size();
    steps_ = find_command_steps(train_, without, info, for_each_);
  }
  return steps_;
}

GapLook::Starts GapLook::starts(const GapFit& without, const std::vector<TrialModel>& more_models) {
  std::vector<TrialEffect> more_starts;
  const std::vector<const EffectInfo*> absent = absent_from(without.model);
  if (const auto rippling = align_wheels(without, absent)) more_starts.push_back(*rippling);
  const auto stepping = std::ranges::find(absent, "command_quantization", &EffectInfo::name);
  if (stepping != absent.end()) {
    if (const auto steps = steps_beside(without, **stepping)) more_starts.push_back(*steps);
  }
  const Screening screening = screen(train_, without, absent, for_each_);
  for (const auto& screened : screening.best) {
    const std::size_t fits = more_models.size() + more_starts.size();
    if (fits >= limits_.most_fits || screened.gain_nats < least_screened_nats) break;
    if (screened.gain_nats < least_screened_share * screening.best.front().gain_nats) break;
    more_starts.push_back(screened.start);
  }
  Starts all;
  all.singles = more_models;
  std::ranges::move(instead_of_core(without.model, absent), std::back_inserter(all.singles));
  const bool far = reaches_far(without.model);
  for (const auto& effect : more_starts) {
    all.singles.push_back(without.model);
    all.singles.back().effects.push_back(effect);
    if (far) all.singles.push_back(beside_bare_core(without.model, {effect}, usual_lags_s));
  }
  if (screening.pair) {
    all.pair = without.model;
    std::ranges::copy(screening.pair->start, std::back_inserter(all.pair->effects));
  }
  return all;
}

// In which the last effects of a model show.
Part GapLook::part_of_last(const TrialModel& model, std::size_t effects) const {
  const Part part = train_.part_of(model.effects.back());
  for (std::size_t i = model.effects.size() - effects; i < model.effects.size(); ++i) {
    if (train_.part_of(model.effects[i]) != part) return Part::all;
  }
  return part;
}

// Of the few best that have a region of the floor in them.
void GapLook::place_regions(Round& round, int steps, RegionSearch placed) const {
  constexpr std::size_t few = 3;
  bool any = false;
  for (std::size_t i = 0; i < std::min(few, round.contenders.size()); ++i) {
    GapFit& fit = round.contenders[i].fit;
    if (!has_region(fit.model)) continue;
    const bool itself = round.contenders[i].effect.info->name == "surface_patch";
    TrialModel model = (itself ? placed : with_region_tuned)(train_, fit.model, for_each_);
    fit = train_.fit(model, steps, part_of_last(model, 1));
    any = true;
  }
  if (any) contest_.judge(round);
}

// What is missing, noise that was estimated without it has taken up: a steady drift looks like a random walk.
// The best of a round in which none is good enough is judged once more, by the noise that it would leave;
// that noise stays where it is good enough then.
bool GapLook::stands_out_of_its_own_noise(const Round& round) {
  const Contender* best = nullptr;
  const auto nats = [](const Contender& one) { return (one.train_nats + one.heldout_nats) / one.inflation; };
  for (const auto& contender : round.contenders) {
    const bool helps = contender.train_nats > 0.0 && contender.heldout_nats > 0.0;
    if (!helps || is_decoy(*contender.effect.info) || contender.effect.info->linear) continue;
    if (best == nullptr || nats(contender) > nats(*best)) best = &contender;
  }
  if (best == nullptr) return false;
  const NoiseModel noise = train_.noise();
  set_noise_left_by(best->fit.model);
  Round alone{train_.fit(round.without.model, steps_of_a_refit), 0.0, {}, {}};
  alone.contenders.resize(1);
  alone.contenders.front().fit =
      train_.fit(best->fit.model, steps_of_a_refit, part_of_last(best->fit.model, 1));
  contest_.judge(alone);
  if (!alone.contenders.empty() && contest_.clear(alone.contenders.front())) return true;
  train_.set_noise(noise);
  heldout_.set_noise(noise);
  return false;
}

// The same for a pair, beside the best that is not one: two effects that hide each other leave what looks the
// most like noise.
bool GapLook::pair_stands_out_of_its_own_noise(const Round& round) {
  constexpr std::size_t few = 3;
  const NoiseModel noise = train_.noise();
  set_noise_left_by(round.pair->model);
  Round again{train_.fit(round.without.model, steps_of_a_refit), 0.0, {}, {}};
  again.pair = train_.fit(round.pair->model, steps_of_a_refit, part_of_last(round.pair->model, 2));
  again.contenders.resize(std::min(few, round.contenders.size()));
  for_each_(again.contenders.size(), [&](std::size_t i) {
    const TrialModel& model = round.contenders[i].fit.model;
    again.contenders[i].fit = train_.fit(model, steps_of_a_refit, part_of_last(model, 1));
  });
  contest_.judge(again);
  if (contest_.pair_worth_adding(*again.pair, again)) return true;
  train_.set_noise(noise);
  heldout_.set_noise(noise);
  return false;
}

// Beside an effect, the core may have got to where no slope had led it, and explain more without that effect,
// too: what it gained there is not the effect's.
GapFit GapLook::with_core_of(const GapFit& without, const TrialModel& contender) const {
  TrialModel model = without.model;
  model.core = contender.core;
  const GapFit fit = train_.fit(model, steps_of_a_refit);
  return fit.squares < without.squares ? fit : without;
}

// Where that core suits a contender better than its own, the contender takes it for a start: all are judged
// against a model that has it.
void GapLook::start_from_core_of(const TrialModel& without, std::vector<Contender>& contenders) const {
  for_each_(contenders.size(), [&](std::size_t i) {
    TrialModel& model = contenders[i].fit.model;
    if (model.core.size() != without.core.size()) return;
    TrialModel other = model;
    other.core = without.core;
    if (squares_of(train_.residuals(other)) < contenders[i].fit.squares) model = std::move(other);
  });
}

Round GapLook::look(const GapFit& without, const std::vector<TrialModel>& more_models) {
  Round round{without, 0.0, {}, {}};
  const Starts tried = starts(without, more_models);
  round.contenders.resize(tried.singles.size());
  if (tried.pair) round.pair.emplace().model = *tried.pair;
  const auto fit_all = [&](int steps, RegionSearch placed) {
    const std::size_t singles = round.contenders.size();
    for_each_(singles + (round.pair ? 1 : 0), [&](std::size_t i) {
      GapFit& fit = i < singles ? round.contenders[i].fit : *round.pair;
      const Part part = part_of_last(fit.model, i < singles ? 1 : 2);
      fit = train_.fit(fit.model, steps, part);
      if (has_threshold(*fit.model.effects.back().info)) {
        fit = train_.fit(with_thresholds_tuned(train_, fit.model), steps, part);
      }
    });
    contest_.judge(round);
    place_regions(round, steps, placed);
  };
  for (std::size_t i = 0; i < tried.singles.size(); ++i) round.contenders[i].fit.model = tried.singles[i];
  fit_all(steps_of_a_fit, with_region_found);
  const bool by_pair = round.pair && (contest_.pair_worth_adding(*round.pair, round) ||
                                      pair_stands_out_of_its_own_noise(round));
  const bool by_single =
      !round.contenders.empty() && round.contenders.front().score >= limits_.least_train_nats;
  if (by_pair || by_single) {
    set_noise_left_by(by_pair ? round.pair->model : round.contenders.front().fit.model);
  } else if (!stands_out_of_its_own_noise(round)) {
    return round;
  }
  round.without = train_.fit(round.without.model, steps_of_a_refit);
  if (by_pair) round.without = with_core_of(round.without, round.pair->model);
  if (by_single) round.without = with_core_of(round.without, round.contenders.front().fit.model);
  start_from_core_of(round.without.model, round.contenders);
  fit_all(steps_of_a_refit, with_region_tuned);
  return round;
}

const Contender* best_named(const Round& round) {
  for (const auto& contender : round.contenders) {
    if (!is_decoy(*contender.effect.info)) return &contender;
  }
  return nullptr;
}

}  // namespace wheelwright::gap
