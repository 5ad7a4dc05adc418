#include "model/gap/selection/candidate_evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/eccentricity_phase.hpp"
#include "model/gap/candidates/fork_search.hpp"
#include "model/gap/candidates/quantization_levels.hpp"
#include "model/gap/candidates/quantization_search.hpp"
#include "model/gap/candidates/region_search.hpp"
#include "model/gap/candidates/threshold_search.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_screened_nats = 4.0;
constexpr double min_screened_share = 0.08;  // of the best one's: less does not become the best by a fit
constexpr std::array default_lags_s{0.03, 0.06, 0.15};

// A linear part that remembers longer than a motor can has taken up something else.
bool reaches_far(const TrialModel& model) {
  constexpr double longest_lag_s = 0.5;
  const LinearModel linear_part = model.linear();
  return std::max(largest_pole(linear_part.left), largest_pole(linear_part.right)) >
         std::exp(-model.period_s / longest_lag_s);
}

TrialModel with_default_linear_part(TrialModel model, double lag_s) {
  const double delay_s = 2.0 * model.period_s;
  model.linear_part =
      first_guess(model.shape, model.period_s, model.wheel_base_m, lag_s, delay_s).linear_part;
  return model;
}

}  // namespace

void CandidateEvaluation::set_noise_left_by(const TrialModel& model) {
  const NoiseModel noise = train_.noise_left_by(model);
  train_.set_noise(noise);
  heldout_.set_noise(noise);
}

// What no slope leads to.
TrialModel CandidateEvaluation::tuned(const TrialModel& model) const {
  const TrialModel centred =
      with_steps_centred(train_, with_steps_tuned(train_, model, parallel_for_), parallel_for_);
  const TrialModel stepping = with_thresholds_tuned(train_, centred);
  return with_region_tuned(train_, stepping, parallel_for_);
}

Fit CandidateEvaluation::settle(TrialModel model, int passes) {
  Fit fit;
  for (int pass = 0; pass < passes; ++pass) {
    set_noise_left_by(model);
    fit = train_.fit(tuned(model), steps_of_a_fit);
    model = fit.model;
  }
  return fit;
}

std::vector<const EffectInfo*> CandidateEvaluation::absent_from(const TrialModel& model) const {
  std::vector<const EffectInfo*> absent;
  for (const EffectInfo* info : candidate_effects_) {
    const auto same = [info](const TrialEffect& effect) { return effect.info == info; };
    if (std::ranges::none_of(model.effects, same)) absent.push_back(info);
  }
  return absent;
}

std::optional<TrialEffect> CandidateEvaluation::align_wheels(
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

const TrialModel& CandidateEvaluation::closest(const std::vector<TrialModel>& models) const {
  std::vector<double> sum_squares(models.size());
  parallel_for_(models.size(),
                [&](std::size_t i) { sum_squares[i] = sum_squares_of(train_.residuals(models[i])); });
  return models[static_cast<std::size_t>(std::ranges::min_element(sum_squares) - sum_squares.begin())];
}

Fit CandidateEvaluation::with_refitted_linear_part(const Fit& fit) {
  std::vector<TrialModel> models;
  models.reserve(default_lags_s.size());
  for (const double lag_s : default_lags_s) models.push_back(with_default_linear_part(fit.model, lag_s));
  constexpr double within_reach = 1.05;  // of the squares
  Fit afresh = train_.fit(closest(models), steps_of_a_fit);
  if (afresh.sum_squares > within_reach * fit.sum_squares) return fit;
  afresh = train_.fit(afresh.model, steps_of_a_fit);
  return afresh.sum_squares < fit.sum_squares ? afresh : fit;
}

// What a linear part has taken up, it does not give back step by step: one of these effects beside a
// linear part that has not seen the data.
TrialModel CandidateEvaluation::beside_default_linear_part(const TrialModel& without,
                                                           const std::vector<TrialEffect>& effects,
                                                           std::span<const double> lags_s) const {
  std::vector<TrialModel> models;
  for (const double lag_s : lags_s) {
    for (const TrialEffect& effect : effects) {
      models.push_back(with_default_linear_part(without, lag_s));
      models.back().effects.push_back(effect);
    }
  }
  return closest(models);
}

// Effects that hold what a linear part usually holds: a delay, two lags.
std::vector<TrialModel> CandidateEvaluation::instead_of_linear_part(
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

// Of the few best that have a fork, once: its shape is found under one noise and fitted on under another.
void CandidateEvaluation::shape_forks(SelectionStep& selection_step, int steps) const {
  bool any = false;
  for (std::size_t i = 0; i < std::min(few, selection_step.candidates.size()); ++i) {
    Fit& fit = selection_step.candidates[i].fit;
    if (!has_fork(fit.model.effects.back())) continue;
    fit = train_.fit(with_fork_found(train_, fit.model, parallel_for_), steps,
                     affected_outputs_of_last(fit.model, 1));
    any = true;
  }
  if (any) comparison_.judge(selection_step);
}

// A step is looked for again only beside more effects than before, which may have hidden it.
std::optional<TrialEffect> CandidateEvaluation::steps_beside(const Fit& without, const EffectInfo& info) {
  if (!steps_beside_ || without.model.effects.size() > *steps_beside_) {
    steps_beside_ = without.model.effects.size();
    steps_ = find_command_steps(train_, without, info, parallel_for_);
  }
  return steps_;
}

CandidateEvaluation::Starts CandidateEvaluation::starts(const Fit& without,
                                                        const std::vector<TrialModel>& more_models) {
  std::vector<TrialEffect> more_starts;
  const std::vector<const EffectInfo*> absent = absent_from(without.model);
  if (const auto rippling = align_wheels(without, absent)) more_starts.push_back(*rippling);
  const auto stepping = std::ranges::find(absent, "command_quantization", &EffectInfo::name);
  if (stepping != absent.end()) {
    if (const auto steps = steps_beside(without, **stepping)) more_starts.push_back(*steps);
  }
  const Screening screening = screen(train_, without, absent, parallel_for_);
  for (const auto& screened : screening.best) {
    const std::size_t fits = more_models.size() + more_starts.size();
    if (fits >= limits_.max_fits || screened.gain_nats < min_screened_nats) break;
    if (screened.gain_nats < min_screened_share * screening.best.front().gain_nats) break;
    more_starts.push_back(screened.start);
  }
  Starts all;
  all.singles = more_models;
  std::ranges::move(instead_of_linear_part(without.model, absent), std::back_inserter(all.singles));
  const bool far = reaches_far(without.model);
  for (const auto& effect : more_starts) {
    all.singles.push_back(without.model);
    all.singles.back().effects.push_back(effect);
    if (far) all.singles.push_back(beside_default_linear_part(without.model, {effect}, default_lags_s));
  }
  if (screening.pair) {
    all.pair = without.model;
    std::ranges::copy(screening.pair->start, std::back_inserter(all.pair->effects));
  }
  return all;
}

// In which the last effects of a model show.
Part CandidateEvaluation::affected_outputs_of_last(const TrialModel& model, std::size_t effects) const {
  const Part part = train_.part_of(model.effects.back());
  for (std::size_t i = model.effects.size() - effects; i < model.effects.size(); ++i) {
    if (train_.part_of(model.effects[i]) != part) return Part::all;
  }
  return part;
}

// Of the few best that have a region of the floor in them.
void CandidateEvaluation::place_regions(SelectionStep& selection_step, int steps, RegionSearch placed) const {
  bool any = false;
  for (std::size_t i = 0; i < std::min(few, selection_step.candidates.size()); ++i) {
    Fit& fit = selection_step.candidates[i].fit;
    if (!has_region(fit.model)) continue;
    const bool itself = selection_step.candidates[i].effect.info->name == "surface_patch";
    TrialModel model = (itself ? placed : with_region_tuned)(train_, fit.model, parallel_for_);
    fit = train_.fit(model, steps, affected_outputs_of_last(model, 1));
    any = true;
  }
  if (any) comparison_.judge(selection_step);
}

// What is missing, noise that was estimated without it has taken up: a steady drift looks like a random walk.
// The best of a round in which none is good enough is judged once more, by the noise that it would leave;
// that noise stays where it is good enough then.
bool CandidateEvaluation::stands_out_of_its_own_noise(const SelectionStep& selection_step) {
  const Candidate* best = nullptr;
  const auto nats = [](const Candidate& one) {
    return one.deflated_train_nats() + one.deflated_unseen_nats();
  };
  for (const auto& candidate : selection_step.candidates) {
    const bool helps = candidate.train_nats > 0.0 && candidate.unseen_nats() > 0.0;
    if (!helps || is_decoy(*candidate.effect.info) || candidate.effect.info->linear) continue;
    if (best == nullptr || nats(candidate) > nats(*best)) best = &candidate;
  }
  if (best == nullptr) return false;
  const NoiseModel noise = train_.noise();
  set_noise_left_by(best->fit.model);
  SelectionStep alone{train_.fit(selection_step.without.model, steps_of_a_refit), 0.0, {}, {}};
  alone.candidates.resize(1);
  alone.candidates.front().fit =
      train_.fit(best->fit.model, steps_of_a_refit, affected_outputs_of_last(best->fit.model, 1));
  comparison_.judge(alone);
  if (!alone.candidates.empty() && comparison_.clear(alone.candidates.front())) return true;
  train_.set_noise(noise);
  heldout_.set_noise(noise);
  return false;
}

// The same for a pair, beside the best that is not one: two effects that hide each other leave what looks the
// most like noise.
bool CandidateEvaluation::pair_stands_out_of_its_own_noise(const SelectionStep& selection_step) {
  const NoiseModel noise = train_.noise();
  set_noise_left_by(selection_step.pair->model);
  SelectionStep again{train_.fit(selection_step.without.model, steps_of_a_refit), 0.0, {}, {}};
  again.pair = train_.fit(selection_step.pair->model, steps_of_a_refit,
                          affected_outputs_of_last(selection_step.pair->model, 2));
  again.candidates.resize(std::min(few, selection_step.candidates.size()));
  parallel_for_(again.candidates.size(), [&](std::size_t i) {
    const TrialModel& model = selection_step.candidates[i].fit.model;
    again.candidates[i].fit = train_.fit(model, steps_of_a_refit, affected_outputs_of_last(model, 1));
  });
  comparison_.judge(again);
  if (comparison_.pair_worth_adding(*again.pair, again)) return true;
  train_.set_noise(noise);
  heldout_.set_noise(noise);
  return false;
}

// Beside an effect, the linear part may have got to where no slope had led it, and explain more without that
// effect, too: what it gained there is not the effect's.
Fit CandidateEvaluation::with_linear_part_of(const Fit& without, const TrialModel& candidate) const {
  TrialModel model = without.model;
  model.linear_part = candidate.linear_part;
  const Fit fit = train_.fit(model, steps_of_a_refit);
  return fit.sum_squares < without.sum_squares ? fit : without;
}

// Where that linear part suits a candidate better than its own, the candidate takes it for a start: all are
// judged against a model that has it.
void CandidateEvaluation::start_from_linear_part_of(const TrialModel& without,
                                                    std::vector<Candidate>& candidates) const {
  parallel_for_(candidates.size(), [&](std::size_t i) {
    TrialModel& model = candidates[i].fit.model;
    if (model.linear_part.size() != without.linear_part.size()) return;
    TrialModel other = model;
    other.linear_part = without.linear_part;
    if (sum_squares_of(train_.residuals(other)) < candidates[i].fit.sum_squares) model = std::move(other);
  });
}

// The best few of different effects that help at all.
std::vector<const Candidate*> CandidateEvaluation::helpful(const SelectionStep& selection_step) const {
  std::vector<const Candidate*> best;
  for (const Candidate& candidate : selection_step.candidates) {
    const bool known = std::ranges::any_of(
        best, [&](const Candidate* other) { return other->effect.info == candidate.effect.info; });
    const bool helps =
        candidate.train_nats > limits_.min_further_nats && candidate.unseen_nats() > limits_.min_further_nats;
    if (!known && helps && !is_decoy(*candidate.effect.info) && best.size() < few) best.push_back(&candidate);
  }
  return best;
}

// Of all runs under the noise that a model with two more effects leaves, refitted, less the price of its
// parameters: what noise that was estimated with another model has taken up, it has to explain, too.
double CandidateEvaluation::own_log_likelihood(Fit& pair) const {
  Problem train = train_;
  Problem heldout = heldout_;
  const NoiseModel noise = train.noise_left_by(pair.model);
  train.set_noise(noise);
  heldout.set_noise(noise);
  pair = train.fit(pair.model, steps_of_a_refit, affected_outputs_of_last(pair.model, 2));
  return train.log_likelihood(pair.residuals) + heldout.log_likelihood(heldout.residuals(pair.model)) -
         comparison_.complexity_penalty(pair.model);
}

void CandidateEvaluation::pair_the_best(SelectionStep& selection_step) {
  struct Pair {
    Fit fit;
    double log_likelihood = 0.0;  // under its own noise
  };
  std::vector<Pair> pairs;
  const std::vector<const Candidate*> best = helpful(selection_step);
  for (std::size_t i = 0; i < best.size(); ++i) {
    for (std::size_t j = i + 1; j < best.size(); ++j) {
      TrialModel& model = pairs.emplace_back().fit.model;
      model = best[i]->fit.model;
      model.effects.push_back(best[j]->effect);
    }
  }
  if (pairs.empty()) return;
  parallel_for_(pairs.size(), [&](std::size_t i) {
    Fit& fit = pairs[i].fit;
    fit = train_.fit(fit.model, steps_of_a_fit, affected_outputs_of_last(fit.model, 2));
    pairs[i].log_likelihood = own_log_likelihood(fit);
  });
  selection_step.pair = std::ranges::max_element(pairs, {}, &Pair::log_likelihood)->fit;
  if (!pair_stands_out_of_its_own_noise(selection_step)) return selection_step.pair.reset();
  selection_step.without = train_.fit(selection_step.without.model, steps_of_a_refit);
  selection_step.pair = train_.fit(selection_step.pair->model, steps_of_a_refit,
                                   affected_outputs_of_last(selection_step.pair->model, 2));
  parallel_for_(selection_step.candidates.size(), [&](std::size_t i) {
    Fit& fit = selection_step.candidates[i].fit;
    fit = train_.fit(fit.model, steps_of_a_refit, affected_outputs_of_last(fit.model, 1));
  });
  comparison_.judge(selection_step);
}

SelectionStep CandidateEvaluation::evaluate(const Fit& without, const std::vector<TrialModel>& more_models) {
  SelectionStep selection_step{without, 0.0, {}, {}};
  const Starts tried = starts(without, more_models);
  selection_step.candidates.resize(tried.singles.size());
  if (tried.pair) selection_step.pair.emplace().model = *tried.pair;
  const auto fit_all = [&](int steps, RegionSearch placed) {
    const std::size_t singles = selection_step.candidates.size();
    parallel_for_(singles + (selection_step.pair ? 1 : 0), [&](std::size_t i) {
      Fit& fit = i < singles ? selection_step.candidates[i].fit : *selection_step.pair;
      const Part part = affected_outputs_of_last(fit.model, i < singles ? 1 : 2);
      fit = train_.fit(fit.model, steps, part);
      const EffectInfo& last = *fit.model.effects.back().info;
      if (has_threshold(last)) fit = train_.fit(with_thresholds_tuned(train_, fit.model), steps, part);
      if (rounds_commands(last)) {
        fit = train_.fit(with_steps_tuned(train_, fit.model, serial_for), steps, part);
      }
    });
    comparison_.judge(selection_step);
    place_regions(selection_step, steps, placed);
  };
  for (std::size_t i = 0; i < tried.singles.size(); ++i)
    selection_step.candidates[i].fit.model = tried.singles[i];
  fit_all(steps_of_a_fit, with_region_found);
  shape_forks(selection_step, steps_of_a_fit);
  const bool by_pair =
      selection_step.pair && (comparison_.pair_worth_adding(*selection_step.pair, selection_step) ||
                              pair_stands_out_of_its_own_noise(selection_step));
  const bool by_single =
      !selection_step.candidates.empty() && selection_step.candidates.front().score >= limits_.min_train_nats;
  if (by_pair || by_single) {
    set_noise_left_by(by_pair ? selection_step.pair->model : selection_step.candidates.front().fit.model);
  } else if (!stands_out_of_its_own_noise(selection_step)) {
    return selection_step;
  }
  selection_step.without = train_.fit(selection_step.without.model, steps_of_a_refit);
  if (by_pair)
    selection_step.without = with_linear_part_of(selection_step.without, selection_step.pair->model);
  if (by_single)
    selection_step.without =
        with_linear_part_of(selection_step.without, selection_step.candidates.front().fit.model);
  start_from_linear_part_of(selection_step.without.model, selection_step.candidates);
  fit_all(steps_of_a_refit, with_region_tuned);
  return selection_step;
}

const Candidate* best_named(const SelectionStep& selection_step) {
  for (const auto& candidate : selection_step.candidates) {
    if (!is_decoy(*candidate.effect.info)) return &candidate;
  }
  return nullptr;
}

}  // namespace wheelwright::gap
