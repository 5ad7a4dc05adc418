#include "model/gap/selection/rival_checks.hpp"

#include <algorithm>
#include <numeric>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/selection/left_out_runs.hpp"

namespace wheelwright::gap {
namespace {

// A fit may end this share short of the best one: where two models lie closer together, the simpler one
// stands.
constexpr double resolution_of_a_fit = 1e-3;

constexpr double clearly_ahead = 2.2;  // of the score: 9 to 1

TrialModel with_last(TrialModel model, std::size_t place) {
  const auto at = model.effects.begin() + static_cast<std::ptrdiff_t>(place);
  std::rotate(at, at + 1, model.effects.end());
  return model;
}

// An effect where it was looked at in its own place; null where it came to nothing there.
const Candidate* itself_in(const SelectionStep& check, const EffectInfo* info) {
  const auto itself = std::ranges::find_if(
      check.candidates, [&](const Candidate& candidate) { return candidate.effect.info == info; });
  return itself == check.candidates.end() ? nullptr : &*itself;
}

// What is said for it on runs that it was not fitted to; nothing where training speaks against it. Where
// held-out runs say something of it, training runs that were left out do not add to that.
double own_nats(const SelectionStep& check, const EffectInfo* info, double min_heldout_nats) {
  const Candidate* itself = itself_in(check, info);
  if (itself == nullptr || itself->train_nats <= 0.0) return 0.0;
  const double heldout_nats = itself->deflated_heldout_nats();
  return heldout_nats < min_heldout_nats ? itself->deflated_unseen_nats() : heldout_nats;
}

// Whether the first of a check is not what is present: another effect, or another variant that explains
// clearly more. A variant was chosen beside fewer effects than there are now.
bool is_another(const Candidate& best, const TrialEffect& present, const SelectionStep& check) {
  if (best.effect.info != present.info) return true;
  if (best.effect.variant == present.variant) return false;
  const auto itself = std::ranges::find_if(check.candidates, [&](const Candidate& candidate) {
    return candidate.effect.info == present.info && candidate.effect.variant == present.variant;
  });
  return itself == check.candidates.end() || best.score > itself->score + clearly_ahead;
}

}  // namespace

// What one effect does is what the next one gets: a rival takes the place of the effect that it replaces.
Fit RivalChecks::in_place(const Candidate& candidate, std::size_t place) const {
  TrialModel model = candidate.fit.model;
  const auto to = model.effects.begin() + static_cast<std::ptrdiff_t>(place);
  if (candidate.behind != 0 || to + 1 == model.effects.end()) return candidate.fit;
  std::rotate(to, model.effects.end() - 1, model.effects.end());
  return train_.fit(model, steps_of_a_fit);
}

// Friction in front of the play is another robot than friction behind it: the best few are judged where the
// effect stood that they are to replace, if they explain more there.
void RivalChecks::try_in_place(SelectionStep& check, std::size_t place) const {
  const auto stage = [](const TrialEffect& effect) { return effect.info->variants[effect.variant].stage; };
  bool any = false;
  for (std::size_t i = 0; i < std::min(max_costly_candidates, check.candidates.size()); ++i) {
    Candidate& candidate = check.candidates[i];
    const auto& effects = candidate.fit.model.effects;
    const std::size_t behind = effects.size() - 1 - place;
    const bool order_matters =
        std::any_of(effects.begin() + static_cast<std::ptrdiff_t>(place), effects.end() - 1,
                    [&](const TrialEffect& other) { return stage(other) == stage(effects.back()); });
    if (!order_matters) continue;
    Fit moved = in_place(candidate, place);
    if (moved.sum_squares >= candidate.fit.sum_squares) continue;
    candidate.fit = std::move(moved);
    candidate.behind = behind;
    any = true;
  }
  if (any) comparison_.judge(check);
}

// A decoy beside which the present effect gains what it takes to be named is no rival of it.
void RivalChecks::leave_out_decoys_of_something_else(SelectionStep& check, const TrialEffect& present) const {
  if (check.candidates.empty() || !is_decoy(*check.candidates.front().effect.info)) return;
  TrialModel both = check.candidates.front().fit.model;
  both.effects.push_back(present);
  if (!comparison_.stands_beside(train_.fit(both, steps_of_a_fit), check.candidates.front())) return;
  std::erase_if(check.candidates, [](const Candidate& one) { return is_decoy(*one.effect.info); });
  comparison_.judge(check);
}

// How far correlation inflates the difference of two effects that explain different things says nothing of
// either; only those that explain the same are rivals.
void RivalChecks::leave_out_rivals_of_something_else(SelectionStep& check, const EffectInfo* than) const {
  constexpr double doubtful = 5.0;  // of the score: 150 to 1
  const auto found = std::ranges::find(check.candidates, than,
                                       [](const Candidate& candidate) { return candidate.effect.info; });
  if (found == check.candidates.end()) return;
  const Candidate itself = *found;
  std::erase_if(check.candidates, [&](const Candidate& rival) {
    if (rival.effect.info == than || is_decoy(*rival.effect.info)) return false;
    if (rival.score < itself.score - doubtful) return false;
    TrialModel both = rival.fit.model;
    both.effects.push_back(itself.effect);
    return comparison_.explains_something_else(train_.fit(both, steps_of_a_fit), itself, rival);
  });
}

// For each accepted effect: would another one do better in its place, now that the others are there?
bool RivalChecks::improve_by_swaps(GapSearch& result, Swaps swaps) {
  bool changed = false;
  for (std::size_t i = result.checks.size(); i < result.final.model.effects.size(); ++i) {
    TrialModel others = result.final.model;
    const TrialEffect present = others.effects[i];
    others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(i));
    const Fit without = evaluation_.with_refitted_linear_part(train_.fit(others, steps_of_a_fit));
    const TrialModel present_last = with_last(result.final.model, i);
    SelectionStep selection_step = evaluation_.evaluate(without, {present_last});
    try_in_place(selection_step, i);
    leave_out_decoys_of_something_else(selection_step, present_last.effects.back());
    // One that is better but explains something else takes the place when swaps are made; after, it is no
    // doubt.
    if (swaps == Swaps::only_looked_at) leave_out_rivals_of_something_else(selection_step, present.info);
    if (!selection_step.candidates.empty()) {
      leave_out_rivals_of_something_else(selection_step, selection_step.candidates.front().effect.info);
    }
    const Candidate* best = best_named(selection_step);
    const bool none = best == nullptr || !comparison_.good_enough(*best);
    if (swaps == Swaps::made && (none || is_another(*best, present, selection_step))) {
      result.final =
          none ? selection_step.without : in_place(*best, i);  // none: not needed beside the others
      changed = true;
    }
    result.checks.push_back(std::move(selection_step));
    if (changed) break;
  }
  return changed;
}

// Swaps look at one effect at a time; a model with another effect that came out worse as a whole is not kept.
void RivalChecks::swap_while_better(GapSearch& result) {
  for (int tries = 0; tries < 3 && !result.final.model.effects.empty(); ++tries) {
    const Fit before = result.final;
    result.checks.clear();
    if (!improve_by_swaps(result, Swaps::made)) return;
    if (result.final.model.effects.size() < before.model.effects.size()) continue;
    const Fit kept = train_.fit(before.model, steps_of_a_refit);
    result.final = train_.fit(result.final.model, steps_of_a_refit);
    const bool simpler = result.final.model.parameter_count() < kept.model.parameter_count();
    const double explained = result.checks.back().candidates.front().score;
    const double margin = simpler ? -resolution_of_a_fit * explained : 0.0;
    if (comparison_.advantage(result.final, kept) > margin) continue;
    result.final = kept;
    for (std::size_t i = 0; i < result.checks.size(); ++i)
      leave_out_rivals_of_something_else(result.checks[i], kept.model.effects[i].info);
    improve_by_swaps(result, Swaps::only_looked_at);
    return;
  }
  check(result);
}

// Beside other effects, one that helps a little is often the shape of the others: such an effect stays only
// where free runs come closer by it. One at a time, the least needed first, since two may stand for each
// other. A delay that a linear part could hold is no more than a better linear model: where it is clear, or
// free runs come closer by it, the linear part holds it from then on; one that no linear part could hold is
// no mere shape. One that does not stand for itself goes whatever the free runs say.
bool RivalChecks::drop_idle(GapSearch& result) {
  const auto& effects = result.final.model.effects;
  if (effects.size() < 2) return false;
  std::vector<double> nats;
  for (std::size_t i = 0; i < effects.size(); ++i)
    nats.push_back(own_nats(result.checks[i], effects[i].info, limits_.min_heldout_nats));
  const double largest = *std::ranges::max_element(nats);
  std::vector<std::size_t> order(effects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return nats[i]; });
  for (const std::size_t place : order) {
    const bool stands = stands_for_itself(result.checks[place], effects[place].info, nats[place], largest);
    const bool linear = effects[place].info->linear;
    const double min_nats = linear ? limits_.clear_delay_nats : limits_.min_idle_nats;
    const bool of_a_linear_part = linear && !beyond_a_linear_part(result.final.model, effects[place]);
    const bool is_clear = stands && nats[place] >= min_nats;
    if (is_clear && !of_a_linear_part) continue;
    TrialModel others = result.final.model;
    others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(place));
    Fit without = evaluation_.with_refitted_linear_part(train_.fit(others, steps_of_a_fit));
    const bool closer = stands && (free_runs_.closer(without.model, result.final.model) ||
                                   shown_by_left_out_runs(result, without, place));
    if (closer && !of_a_linear_part) continue;
    if (closer || is_clear) {
      const double delay_s = effects[place].parameters.front();
      without = train_.fit(others.with_later_linear_part(delay_s), steps_of_a_refit);
    }
    result.final = std::move(without);
    return true;
  }
  return false;
}

// Held-out runs may hardly drive where an effect acts, and yet not speak against it: then training runs say
// by each other whether it is there.
bool RivalChecks::shown_by_left_out_runs(const GapSearch& result, const Fit& without,
                                         std::size_t place) const {
  const Candidate* itself = itself_in(result.checks[place], result.final.model.effects[place].info);
  if (itself == nullptr) return false;
  if (itself->deflated_heldout_nats() < -limits_.min_heldout_nats) return false;
  return left_out_runs_gain_nats(train_, without, result.final, place) >
         limits_.clear_left_out_nats * itself->train_autocorrelation_factor;
}

// One that helps a little and in whose place another would help more does not, nor one that a decoy beats,
// nor one that is small beside the others and hardly told from its rivals.
bool RivalChecks::stands_for_itself(const SelectionStep& check, const EffectInfo* info, double nats,
                                    double largest) const {
  if (check.candidates.empty()) return nats >= limits_.min_idle_nats;
  const Candidate& first = check.candidates.front();
  if (is_decoy(*first.effect.info)) return false;
  if (first.effect.info != info) return nats >= limits_.min_idle_nats;
  const auto rival = std::ranges::find_if(
      check.candidates, [&](const Candidate& candidate) { return candidate.effect.info != info; });
  const bool told = rival == check.candidates.end() || first.score - rival->score > clearly_ahead;
  return told || nats >= limits_.min_share * largest;
}

void RivalChecks::check(GapSearch& result) {
  result.checks.clear();
  improve_by_swaps(result, Swaps::only_looked_at);
}

}  // namespace wheelwright::gap
