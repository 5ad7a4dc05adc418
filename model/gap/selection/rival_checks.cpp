#include "model/gap/selection/rival_checks.hpp"

#include <algorithm>
#include <numeric>

#include "model/gap/candidates/decoys.hpp"

namespace wheelwright::gap {
namespace {

// A fit may end this share short of the best one: where two models lie closer together, the simpler one
// stands.
constexpr double resolution_of_a_fit = 1e-3;

TrialModel with_last(TrialModel model, std::size_t place) {
  const auto at = model.effects.begin() + static_cast<std::ptrdiff_t>(place);
  std::rotate(at, at + 1, model.effects.end());
  return model;
}

// What is said for an effect where it was looked at in its own place; nothing where training speaks against
// it.
double own_nats(const Round& check, const EffectInfo* info) {
  const auto itself = std::ranges::find_if(
      check.contenders, [&](const Contender& contender) { return contender.effect.info == info; });
  if (itself == check.contenders.end() || itself->train_nats <= 0.0) return 0.0;
  return itself->heldout_nats / itself->inflation;
}

}  // namespace

// What one effect does is what the next one gets: a rival takes the place of the effect that it replaces.
GapFit GapChecks::in_place(const Contender& contender, std::size_t place) const {
  TrialModel model = contender.fit.model;
  const auto to = model.effects.begin() + static_cast<std::ptrdiff_t>(place);
  if (contender.behind != 0 || to + 1 == model.effects.end()) return contender.fit;
  std::rotate(to, model.effects.end() - 1, model.effects.end());
  return train_.fit(model, steps_of_a_fit);
}

// Friction in front of the play is another robot than friction behind it: the best few are judged where the
// effect stood that they are to replace, if they explain more there.
void GapChecks::try_in_place(Round& check, std::size_t place) const {
  constexpr std::size_t few = 3;
  const auto stage = [](const TrialEffect& effect) { return effect.info->variants[effect.variant].stage; };
  bool any = false;
  for (std::size_t i = 0; i < std::min(few, check.contenders.size()); ++i) {
    Contender& contender = check.contenders[i];
    const auto& effects = contender.fit.model.effects;
    const std::size_t behind = effects.size() - 1 - place;
    const bool order_matters =
        std::any_of(effects.begin() + static_cast<std::ptrdiff_t>(place), effects.end() - 1,
                    [&](const TrialEffect& other) { return stage(other) == stage(effects.back()); });
    if (!order_matters) continue;
    GapFit moved = in_place(contender, place);
    if (moved.squares >= contender.fit.squares) continue;
    contender.fit = std::move(moved);
    contender.behind = behind;
    any = true;
  }
  if (any) contest_.judge(check);
}

// A decoy beside which the present effect gains what it takes to be named is no rival of it.
void GapChecks::leave_out_decoys_of_something_else(Round& check, const TrialEffect& present) const {
  if (check.contenders.empty() || !is_decoy(*check.contenders.front().effect.info)) return;
  TrialModel both = check.contenders.front().fit.model;
  both.effects.push_back(present);
  if (!contest_.stands_beside(train_.fit(both, steps_of_a_fit), check.contenders.front())) return;
  std::erase_if(check.contenders, [](const Contender& one) { return is_decoy(*one.effect.info); });
  contest_.judge(check);
}

// How far correlation inflates the difference of two effects that explain different things says nothing of
// either; only those that explain the same are rivals.
void GapChecks::leave_out_rivals_of_something_else(Round& check, const EffectInfo* than) const {
  constexpr double doubtful = 5.0;  // of the score: 150 to 1
  const auto found = std::ranges::find(check.contenders, than,
                                       [](const Contender& contender) { return contender.effect.info; });
  if (found == check.contenders.end()) return;
  const Contender itself = *found;
  std::erase_if(check.contenders, [&](const Contender& rival) {
    if (rival.effect.info == than || is_decoy(*rival.effect.info)) return false;
    if (rival.score < itself.score - doubtful) return false;
    TrialModel both = rival.fit.model;
    both.effects.push_back(itself.effect);
    return contest_.explains_something_else(train_.fit(both, steps_of_a_fit), itself, rival);
  });
}

// For each accepted effect: would another one do better in its place, now that the others are there?
bool GapChecks::improve_by_swaps(GapSearch& result, Swaps swaps) {
  bool changed = false;
  result.checks.clear();
  for (std::size_t i = 0; i < result.final.model.effects.size(); ++i) {
    TrialModel others = result.final.model;
    const TrialEffect present = others.effects[i];
    others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(i));
    const GapFit without = look_.with_core_afresh(train_.fit(others, steps_of_a_fit));
    const TrialModel present_last = with_last(result.final.model, i);
    Round round = look_.look(without, {present_last});
    try_in_place(round, i);
    leave_out_decoys_of_something_else(round, present_last.effects.back());
    // One that is better but explains something else takes the place when swaps are made; after, it is no
    // doubt.
    if (swaps == Swaps::only_looked_at) leave_out_rivals_of_something_else(round, present.info);
    if (!round.contenders.empty()) {
      leave_out_rivals_of_something_else(round, round.contenders.front().effect.info);
    }
    const Contender* best = best_named(round);
    const bool none = best == nullptr || !contest_.good_enough(*best);
    if (swaps == Swaps::made && (none || best->effect.info != present.info)) {
      result.final = none ? round.without : in_place(*best, i);  // none: not needed beside the others
      changed = true;
    }
    result.checks.push_back(std::move(round));
    if (changed) break;
  }
  return changed;
}

// Swaps look at one effect at a time; a model with another effect that came out worse as a whole is not kept.
void GapChecks::swap_while_better(GapSearch& result) {
  for (int tries = 0; tries < 3 && !result.final.model.effects.empty(); ++tries) {
    const GapFit before = result.final;
    if (!improve_by_swaps(result, Swaps::made)) return;
    if (result.final.model.effects.size() < before.model.effects.size()) continue;
    const GapFit kept = train_.fit(before.model, steps_of_a_refit);
    result.final = train_.fit(result.final.model, steps_of_a_refit);
    const bool simpler = result.final.model.parameter_count() < kept.model.parameter_count();
    const double explained = result.checks.back().contenders.front().score;
    const double margin = simpler ? -resolution_of_a_fit * explained : 0.0;
    if (contest_.advantage(result.final, kept) > margin) continue;
    result.final = kept;
    break;
  }
  improve_by_swaps(result, Swaps::only_looked_at);
}

// Beside other effects, one that helps a little is often the shape of the others: such an effect stays only
// where free runs come closer by it. One at a time, the least needed first, since two may stand for each
// other. A delay that a core could hold is no more than a better linear model: where it is clear, or free
// runs come closer by it, the core holds it from then on; one that no core could hold is no mere shape. One
// that does not stand for itself goes whatever the free runs say.
bool GapChecks::drop_idle(GapSearch& result) {
  const auto& effects = result.final.model.effects;
  if (effects.size() < 2) return false;
  std::vector<double> nats;
  for (std::size_t i = 0; i < effects.size(); ++i)
    nats.push_back(own_nats(result.checks[i], effects[i].info));
  const double largest = *std::ranges::max_element(nats);
  std::vector<std::size_t> order(effects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return nats[i]; });
  for (const std::size_t place : order) {
    const bool stands = stands_for_itself(result.checks[place], effects[place].info, nats[place], largest);
    const bool linear = effects[place].info->linear;
    const double least_nats = linear ? limits_.clear_delay_nats : limits_.least_idle_nats;
    const bool of_a_core = linear && !beyond_a_core(effects[place]);
    const bool is_clear = stands && nats[place] >= least_nats;
    if (is_clear && !of_a_core) continue;
    TrialModel others = result.final.model;
    others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(place));
    GapFit without = look_.with_core_afresh(train_.fit(others, steps_of_a_fit));
    const bool closer = stands && free_runs_.closer(without.model, result.final.model);
    if (closer && !of_a_core) continue;
    if (closer || is_clear) {
      const double delay_s = effects[place].parameters.front();
      without = train_.fit(others.with_later_core(delay_s), steps_of_a_refit);
    }
    result.final = std::move(without);
    return true;
  }
  return false;
}

// One that helps a little and in whose place another would help more does not, nor one that a decoy beats,
// nor one that is small beside the others and hardly told from its rivals.
bool GapChecks::stands_for_itself(const Round& check, const EffectInfo* info, double nats,
                                  double largest) const {
  constexpr double told_by = 2.2;  // of the score: 9 to 1
  if (check.contenders.empty()) return nats >= limits_.least_idle_nats;
  const Contender& first = check.contenders.front();
  if (is_decoy(*first.effect.info)) return false;
  if (first.effect.info != info) return nats >= limits_.least_idle_nats;
  const auto rival = std::ranges::find_if(
      check.contenders, [&](const Contender& contender) { return contender.effect.info != info; });
  const bool told = rival == check.contenders.end() || first.score - rival->score > told_by;
  return told || nats >= limits_.least_share * largest;
}

void GapChecks::check(GapSearch& result) {
  improve_by_swaps(result, Swaps::only_looked_at);
}

}  // namespace wheelwright::gap
