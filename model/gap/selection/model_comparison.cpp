#include "model/gap/selection/model_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/runs/fastest_command.hpp"
#include "model/gap/selection/autocorrelation_factor.hpp"
#include "model/gap/selection/left_out_runs.hpp"

namespace wheelwright::gap {
namespace {

// Of several sizes, all have to be.
bool negligible(const TrialEffect& effect) {
  bool any = false;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const double least = effect.parameter_info(i).negligible;
    if (least == 0.0) continue;
    if (std::abs(effect.parameters[i]) >= least) return false;
    any = true;
  }
  return any;
}

const TrialEffect& effect_of(const Candidate& candidate) {
  const auto& effects = candidate.fit.model.effects;
  return effects[effects.size() - 1 - candidate.behind];
}

// Mean delay of a wheel's own weights, of both wheels.
double delay_of_weights_s(const TrialModel& model) {
  const LinearModel linear = model.linear();
  double moment = 0.0;
  double sum = 0.0;
  for (const auto* weights : {&linear.left.from_left, &linear.right.from_right}) {
    for (std::size_t i = 0; i < weights->size(); ++i) {
      moment += static_cast<double>(i) * (*weights)[i];
      sum += (*weights)[i];
    }
  }
  return sum > 0.0 ? model.period_s * std::max(0.0, moment / sum) : 0.0;
}

}  // namespace

ModelComparison::ModelComparison(const FitProblem& train, const FitProblem& heldout,
                                 const SearchLimits& limits)
    : train_(train),
      heldout_(heldout),
      limits_(limits),
      largest_command_m_s_(std::max(fastest_command_m_s(train.runs()), fastest_command_m_s(heldout.runs()))) {
}

// A sound robot acts 50 to 100 ms late (source paper), and its motor's lag adds to that: a linear part
// holds it, and so it does two periods, in which one is measured and the next command computed. What a fit
// leaves to its weights and what to the effect is chance.
bool beyond_a_linear_part(const TrialModel& model, const TrialEffect& effect) {
  const double reach_of_a_linear_part_s = std::max(0.12, 2.0 * model.period_s);
  return effect.info->linear &&
         effect.parameters.front() + delay_of_weights_s(model) > reach_of_a_linear_part_s;
}

double ModelComparison::penalty_per_parameter() const {
  return 0.5 * std::log(static_cast<double>(train_.readings() + heldout_.readings()));
}

double ModelComparison::complexity_penalty(const TrialEffect& effect) const {
  auto parameters = effect.parameters.size();
  if (effect.info->by_wheel_angle && angles_differ_) {
    parameters += 2 * (train_.runs().size() + heldout_.runs().size() - 1);
  }
  return penalty_per_parameter() * static_cast<double>(parameters);
}

double ModelComparison::complexity_penalty(const TrialModel& model) const {
  double sum = penalty_per_parameter() * static_cast<double>(model.linear_part.size());
  for (const auto& effect : model.effects) sum += complexity_penalty(effect);
  return sum;
}

Candidate ModelComparison::judged(const Fit& without, const std::vector<double>& heldout_without,
                                  Candidate candidate) const {
  const Fit& fit = candidate.fit;
  candidate.effect = effect_of(candidate);
  candidate.train_nats = 0.5 * (without.sum_squares - fit.sum_squares);
  candidate.heldout_residuals = heldout_.residuals(fit.model);
  candidate.heldout_nats =
      0.5 * (sum_squares_of(heldout_without) - sum_squares_of(candidate.heldout_residuals));
  candidate.train_autocorrelation_factor =
      autocorrelation_factor_of_gain(train_, candidate.train_nats, without.residuals, fit.residuals);
  candidate.heldout_autocorrelation_factor = autocorrelation_factor_of_gain(
      heldout_, candidate.heldout_nats, heldout_without, candidate.heldout_residuals);
  if (candidate.effect.info->by_wheel_angle && angles_differ_) {
    // Two angles were taken from each held-out run: that much they explain of mere noise.
    candidate.heldout_nats -=
        candidate.heldout_autocorrelation_factor * static_cast<double>(heldout_.runs().size());
  }
  // As long as nothing is found, other runs can be held out, in which it acts: that proves more.
  const bool something_found = !without.model.effects.empty();
  candidate.left_out_nats = 0.0;
  if (undecided_by_held_out_runs(candidate, something_found) &&
      (something_found || acts_in_held_out_runs(candidate)))
    candidate.left_out_nats =
        left_out_runs_gain_nats(train_, without, fit, fit.model.effects.size() - 1 - candidate.behind);
  return candidate;
}

// Whether training leaves no doubt, and held-out runs neither confirm it, as a first effect or a further one
// has to be, nor refute it: they may not reach the speed or the turn in which it shows.
bool ModelComparison::undecided_by_held_out_runs(const Candidate& candidate, bool is_further) const {
  const double train_nats = candidate.deflated_train_nats();
  const double heldout_nats = candidate.deflated_heldout_nats();
  const double confirming_nats = is_further ? limits_.min_further_nats : limits_.min_heldout_nats;
  return train_nats > limits_.clear_train_nats && heldout_nats > -limits_.min_heldout_nats &&
         heldout_nats < confirming_nats;
}

bool ModelComparison::acts_in_held_out_runs(const Candidate& candidate) const {
  TrialModel without = candidate.fit.model;
  without.effects.erase(without.effects.end() - 1 - static_cast<std::ptrdiff_t>(candidate.behind));
  return heldout_.residuals(without) != candidate.heldout_residuals;
}

void ModelComparison::judge(SelectionStep& selection_step) const {
  const std::vector<double> heldout_without = heldout_.residuals(selection_step.without.model);
  selection_step.heldout_sum_squares = sum_squares_of(heldout_without);
  // What an effect of no consequence explains, its linear part explains; what one out of character does,
  // another.
  std::erase_if(selection_step.candidates, [this](const Candidate& candidate) {
    const TrialEffect& effect = effect_of(candidate);
    const auto& in_character = effect.info->in_character;
    return negligible(effect) ||
           (in_character && !in_character({effect.parameters, effect.variant}, largest_command_m_s_));
  });
  for (auto& candidate : selection_step.candidates) {
    candidate = judged(selection_step.without, heldout_without, std::move(candidate));
  }
  // A fit that runs away on runs that it has not seen is no fit.
  std::erase_if(selection_step.candidates, [this](const Candidate& one) {
    return !std::isfinite(one.train_nats) || !std::isfinite(one.heldout_nats) || acts_linearly(one);
  });
  rank(selection_step.candidates);
  leave_out_aliases(selection_step.candidates);
}

// Where all that it is more than a lag plays next to no part in these runs, the linear part lacks a lag.
bool ModelComparison::acts_linearly(const Candidate& candidate) const {
  const TrialEffect& effect = candidate.effect;
  if (!effect.info->linear_part) return false;
  TrialModel linear = candidate.fit.model;
  linear.effects[linear.effects.size() - 1 - candidate.behind].parameters =
      effect.info->linear_part({effect.parameters, effect.variant});
  const double lost_nats = 0.5 * (sum_squares_of(train_.residuals(linear)) - candidate.fit.sum_squares);
  return lost_nats < limits_.min_further_nats;
}

double ModelComparison::autocorrelation_factor_between(const Candidate& worse,
                                                       const Candidate& better) const {
  return std::max(autocorrelation_factor_of(train_, worse.fit.residuals, better.fit.residuals),
                  autocorrelation_factor_of(heldout_, worse.heldout_residuals, better.heldout_residuals));
}

// By likelihood less the price of the parameters. The best one is measured against the model without it, the
// others against the best one: how much correlation inflates a difference hangs on what the two differ in.
// One that only training or only held-out runs speak for comes behind all that both speak for.
void ModelComparison::rank(std::vector<Candidate>& candidates) const {
  if (candidates.empty()) return;
  const auto holds = [](const Candidate& one) { return one.train_nats > 0.0 && one.unseen_nats() > 0.0; };
  const auto nats = [](const Candidate& one) { return one.train_nats + one.heldout_nats; };
  const Candidate& best = *std::ranges::max_element(candidates, [&](const Candidate& a, const Candidate& b) {
    return std::pair(holds(a), nats(a)) < std::pair(holds(b), nats(b));
  });
  const double best_score = score_alone(best);
  for (auto& candidate : candidates) {
    candidate.score = best_score;
    if (&candidate == &best) continue;
    candidate.score -= (nats(best) - nats(candidate)) / autocorrelation_factor_between(candidate, best);
    candidate.score -= complexity_penalty(candidate.effect) - complexity_penalty(best.effect);
    if (!holds(candidate)) candidate.score = std::min(candidate.score, 0.0);
  }
  std::ranges::sort(candidates, std::greater<>{}, &Candidate::score);
}

// On some drives a decoy does what an effect of the library does (where both wheels are always told the same
// speed, each one's own and the other's are the same): one that explains the same as a name is no rival.
void ModelComparison::leave_out_aliases(std::vector<Candidate>& candidates) {
  constexpr double same = 0.01;  // of the score
  const auto is_named = [](const Candidate& one) { return !is_decoy(*one.effect.info); };
  const auto named = std::ranges::find_if(candidates, is_named);
  if (named == candidates.end() || named->score <= 0.0) return;
  const double score = named->score;
  std::erase_if(candidates, [&](const Candidate& one) {
    return !is_named(one) && std::abs(one.score - score) < same * score;
  });
}

double ModelComparison::core_score(const SelectionStep& selection_step, const Fit& richer) const {
  const double train_nats = 0.5 * (selection_step.without.sum_squares - richer.sum_squares);
  const double heldout_nats =
      0.5 * (selection_step.heldout_sum_squares - sum_squares_of(heldout_.residuals(richer.model)));
  const double autocorrelation_factor = std::max(
      autocorrelation_factor_of(train_, selection_step.without.residuals, richer.residuals),
      selection_step.candidates.empty() ? 1.0 : selection_step.candidates.front().autocorrelation_factor());
  if (heldout_nats / autocorrelation_factor < limits_.min_linear_part_nats) return 0.0;
  return (train_nats + heldout_nats) / autocorrelation_factor - complexity_penalty(richer.model) +
         complexity_penalty(selection_step.without.model);
}

double ModelComparison::advantage(const Fit& one, const Fit& other) const {
  const std::vector<double> heldout_one = heldout_.residuals(one.model);
  const std::vector<double> heldout_other = heldout_.residuals(other.model);
  const double nats = 0.5 * (other.sum_squares - one.sum_squares + sum_squares_of(heldout_other) -
                             sum_squares_of(heldout_one));
  const auto autocorrelation_factor = [&](const Fit& worse, const std::vector<double>& heldout_worse,
                                          const Fit& better, const std::vector<double>& heldout_better) {
    return std::max(autocorrelation_factor_of(train_, worse.residuals, better.residuals),
                    autocorrelation_factor_of(heldout_, heldout_worse, heldout_better));
  };
  const double deflated =
      nats / (nats > 0.0 ? autocorrelation_factor(other, heldout_other, one, heldout_one)
                         : autocorrelation_factor(one, heldout_one, other, heldout_other));
  return deflated - complexity_penalty(one.model) + complexity_penalty(other.model);
}

double ModelComparison::score_alone(const Candidate& candidate) const {
  return (candidate.train_nats + candidate.heldout_nats) / candidate.autocorrelation_factor() -
         complexity_penalty(candidate.effect);
}

bool ModelComparison::good_enough(const Candidate& candidate) const {
  const double unseen_nats = candidate.deflated_unseen_nats();
  const double train_nats = candidate.deflated_train_nats();
  const bool both = unseen_nats > limits_.min_heldout_nats && train_nats > limits_.min_train_nats;
  const bool confirmed = unseen_nats > limits_.confirming_nats && train_nats > limits_.clear_train_nats;
  return (both || confirmed) && score_alone(candidate) > 0.0;
}

bool ModelComparison::clear(const Candidate& candidate) const {
  return good_enough(candidate) && candidate.deflated_unseen_nats() > limits_.min_further_nats &&
         candidate.deflated_train_nats() > limits_.min_further_nats;
}

bool ModelComparison::worth_adding(const Candidate& candidate, std::span<const SelectionStep> so_far) const {
  const auto all_nats = [](const Candidate& one) {
    return (one.train_nats + one.heldout_nats) / one.autocorrelation_factor();
  };
  // With counts, what the wheels do of their commands leaves nothing in the motion beyond odometry.
  const auto in_same_readings = [&](const Candidate& other) {
    return train_.outputs_of(other.effect) == train_.outputs_of(candidate.effect);
  };
  bool is_further = false;
  double largest = 0.0;
  for (const auto& selection_step : so_far) {
    if (selection_step.candidates.empty()) continue;
    const Candidate& best = selection_step.candidates.front();
    is_further = true;
    if (in_same_readings(best)) largest = std::max(largest, all_nats(best));
  }
  // What a wrong shape of the strongest effect leaves, another may fit, but not so that noise alone is left.
  const double factor = candidate.autocorrelation_factor();
  const double min_share = std::min(limits_.min_share, limits_.min_share_before_noise * factor * factor);
  const double unseen_nats = candidate.deflated_unseen_nats();
  return good_enough(candidate) && (!is_further || (unseen_nats > limits_.min_further_nats &&
                                                    all_nats(candidate) > min_share * largest));
}

bool ModelComparison::clearly_better(const Fit& with, const Fit& without) const {
  const std::vector<double> heldout_without = heldout_.residuals(without.model);
  const std::vector<double> heldout_with = heldout_.residuals(with.model);
  const double train_nats = 0.5 * (without.sum_squares - with.sum_squares);
  const double heldout_nats = 0.5 * (sum_squares_of(heldout_without) - sum_squares_of(heldout_with));
  return train_nats > limits_.min_further_nats *
                          autocorrelation_factor_of(train_, without.residuals, with.residuals) &&
         heldout_nats >
             limits_.min_further_nats * autocorrelation_factor_of(heldout_, heldout_without, heldout_with);
}

bool ModelComparison::stands_beside(const Fit& both, const Candidate& other) const {
  Candidate beside;
  beside.fit = both;
  return clear(judged(other.fit, other.heldout_residuals, std::move(beside)));
}

bool ModelComparison::explains_something_else(const Fit& both, const Candidate& one,
                                              const Candidate& other) const {
  constexpr double about_as_much = 0.7;
  const double train_nats = 0.5 * (other.fit.sum_squares - both.sum_squares);
  const double heldout_nats =
      0.5 * (sum_squares_of(other.heldout_residuals) - sum_squares_of(heldout_.residuals(both.model)));
  return train_nats > about_as_much * one.train_nats && heldout_nats > about_as_much * one.heldout_nats;
}

bool ModelComparison::pair_worth_adding(const Fit& pair, const SelectionStep& selection_step) const {
  return clearly_better(pair, selection_step.without) &&
         (selection_step.candidates.empty() || advantage(pair, selection_step.candidates.front().fit) > 0.0);
}

}  // namespace wheelwright::gap
