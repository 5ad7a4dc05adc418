#include "model/gap/selection/candidate_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/fork_search.hpp"
#include "model/gap/candidates/quantization_search.hpp"
#include "model/gap/candidates/region_search.hpp"
#include "model/gap/candidates/threshold_search.hpp"
#include "model/gap/selection/default_linear_part.hpp"
#include "model/gap/selection/unequal_wheels.hpp"

namespace wheelwright::gap {

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

Fit CandidateEvaluation::with_refitted_linear_part(const Fit& fit) {
  std::vector<TrialModel> models;
  models.reserve(default_lags_s.size());
  for (const double lag_s : default_lags_s) models.push_back(with_default_linear_part(fit.model, lag_s));
  constexpr double within_reach = 1.05;  // of the squares
  Fit afresh = train_.fit(closest_to_runs(train_, models, parallel_for_), steps_of_a_fit);
  if (afresh.sum_squares > within_reach * fit.sum_squares) return fit;
  afresh = train_.fit(afresh.model, steps_of_a_fit);
  return afresh.sum_squares < fit.sum_squares ? afresh : fit;
}

// Of the few best that have a fork, once: its shape is found under one noise and fitted on under another.
void CandidateEvaluation::shape_forks(SelectionStep& selection_step, int steps) const {
  bool any = false;
  for (std::size_t i = 0; i < std::min(max_costly_candidates, selection_step.candidates.size()); ++i) {
    Fit& fit = selection_step.candidates[i].fit;
    if (!has_fork(fit.model.effects.back())) continue;
    fit = train_.fit(with_fork_found(train_, fit.model, parallel_for_), steps,
                     affected_outputs_of_last(fit.model, 1));
    any = true;
  }
  if (any) comparison_.judge(selection_step);
}

// In which the last effects of a model show.
Outputs CandidateEvaluation::affected_outputs_of_last(const TrialModel& model, std::size_t effects) const {
  const Outputs outputs = train_.outputs_of(model.effects.back());
  for (std::size_t i = model.effects.size() - effects; i < model.effects.size(); ++i) {
    if (train_.outputs_of(model.effects[i]) != outputs) return Outputs::all;
  }
  return outputs;
}

// Of the few best that have a region of the floor in them.
void CandidateEvaluation::place_regions(SelectionStep& selection_step, int steps, RegionSearch placed) const {
  bool any = false;
  for (std::size_t i = 0; i < std::min(max_costly_candidates, selection_step.candidates.size()); ++i) {
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
  again.candidates.resize(std::min(max_costly_candidates, selection_step.candidates.size()));
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
    if (!known && helps && !is_decoy(*candidate.effect.info) && best.size() < max_costly_candidates)
      best.push_back(&candidate);
  }
  return best;
}

// Of all runs under the noise that a model with so many more effects leaves, refitted, less the price of its
// parameters: what noise that was estimated with another model has taken up, it has to explain, too.
double CandidateEvaluation::own_log_likelihood(Fit& fit, std::size_t effects) const {
  FitProblem train = train_;
  FitProblem heldout = heldout_;
  const NoiseModel noise = train.noise_left_by(fit.model);
  train.set_noise(noise);
  heldout.set_noise(noise);
  fit = train.fit(fit.model, steps_of_a_refit, affected_outputs_of_last(fit.model, effects));
  const double log_likelihood = train.log_likelihood(fit.residuals) +
                                heldout.log_likelihood(heldout.residuals(fit.model)) -
                                comparison_.complexity_penalty(fit.model);
  return std::isfinite(log_likelihood) ? log_likelihood : -std::numeric_limits<double>::infinity();
}

// Of the best few that come near the first one's score: under a noise that none of them has left, the one
// that is there may be behind.
TrialModel CandidateEvaluation::likeliest_under_its_own_noise(const SelectionStep& selection_step) const {
  constexpr double near = 0.5;  // of the first one's score
  struct Contender {
    Fit fit;
    double log_likelihood = 0.0;
  };
  std::vector<Contender> contenders;
  for (const Candidate& candidate : selection_step.candidates) {
    const bool known = std::ranges::any_of(contenders, [&](const Contender& other) {
      return other.fit.model.effects.back().info == candidate.effect.info;
    });
    if (known) continue;
    if (contenders.size() == max_costly_candidates ||
        candidate.score < near * selection_step.candidates.front().score)
      break;
    contenders.emplace_back().fit = candidate.fit;
  }
  if (contenders.size() == 1) return contenders.front().fit.model;
  parallel_for_(contenders.size(), [&](std::size_t i) {
    contenders[i].log_likelihood = own_log_likelihood(contenders[i].fit, 1);
  });
  return std::ranges::max_element(contenders, {}, &Contender::log_likelihood)->fit.model;
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
    pairs[i].log_likelihood = own_log_likelihood(fit, 2);
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
  const CandidateStarts::Models tried = starts_.beside(without, more_models);
  selection_step.candidates.resize(tried.singles.size());
  if (tried.pair) selection_step.pair.emplace().model = *tried.pair;
  const auto fit_all = [&](int steps, RegionSearch placed) {
    const std::size_t singles = selection_step.candidates.size();
    parallel_for_(singles + (selection_step.pair ? 1 : 0), [&](std::size_t i) {
      Fit& fit = i < singles ? selection_step.candidates[i].fit : *selection_step.pair;
      const Outputs outputs = affected_outputs_of_last(fit.model, i < singles ? 1 : 2);
      fit = train_.fit(fit.model, steps, outputs);
      const EffectInfo& last = *fit.model.effects.back().info;
      if (has_threshold(last)) fit = train_.fit(with_thresholds_tuned(train_, fit.model), steps, outputs);
      if (rounds_commands(last)) {
        fit = train_.fit(with_steps_tuned(train_, fit.model, serial_for), steps, outputs);
      }
    });
    comparison_.judge(selection_step);
    place_regions(selection_step, steps, placed);
  };
  for (std::size_t i = 0; i < tried.singles.size(); ++i)
    selection_step.candidates[i].fit.model = tried.singles[i];
  fit_all(steps_of_a_fit, with_region_found);
  shape_forks(selection_step, steps_of_a_fit);
  size_each_wheel(train_, comparison_, limits_, selection_step, parallel_for_);
  const bool by_pair =
      selection_step.pair && (comparison_.pair_worth_adding(*selection_step.pair, selection_step) ||
                              pair_stands_out_of_its_own_noise(selection_step));
  const bool by_single =
      !selection_step.candidates.empty() && selection_step.candidates.front().score >= limits_.min_train_nats;
  std::optional<TrialModel> likeliest;
  if (by_single) likeliest = likeliest_under_its_own_noise(selection_step);
  if (by_pair || by_single) {
    set_noise_left_by(by_pair ? selection_step.pair->model : *likeliest);
  } else if (!stands_out_of_its_own_noise(selection_step)) {
    return selection_step;
  }
  selection_step.without = train_.fit(selection_step.without.model, steps_of_a_refit);
  if (by_pair)
    selection_step.without = with_linear_part_of(selection_step.without, selection_step.pair->model);
  if (likeliest) selection_step.without = with_linear_part_of(selection_step.without, *likeliest);
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
