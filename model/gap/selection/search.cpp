#include "model/gap/selection/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/flat_places.hpp"
#include "model/gap/candidates/quantization_search.hpp"
#include "model/gap/selection/candidate_evaluation.hpp"
#include "model/gap/selection/rival_checks.hpp"

namespace wheelwright::gap {
namespace {

std::vector<const EffectInfo*> infos_of(const TrialModel& model) {
  std::vector<const EffectInfo*> infos;
  infos.reserve(model.effects.size());
  for (const auto& effect : model.effects) infos.push_back(effect.info);
  return infos;
}

// One way through the effects: the rounds so far, and the model that they led to.
struct Path {
  std::vector<Round> rounds;
  GapFit model;
  bool met_another = false;  // which goes on from here
};

class Search {
 public:
  Search(GapProblem& train, GapProblem& heldout, std::span<const EffectInfo* const> candidates,
         const SearchLimits& limits, const FreeRuns& free_runs, const ForEach& for_each,
         const Progress& progress)
      : train_(train),
        heldout_(heldout),
        limits_(limits),
        free_runs_(free_runs),
        for_each_(for_each),
        progress_(progress),
        contest_(train, heldout, limits_),
        look_(train, heldout, contest_, candidates, limits_, for_each),
        checks_(train, contest_, look_, limits_, free_runs) {}

  GapSearch run(const TrialModel& start);

 private:
  Round first_round(const TrialModel& start);
  std::vector<TrialModel> richer_cores(const TrialModel& present) const;
  std::optional<GapFit> better_core(const Round& round) const;
  bool helps_what_is_off(const Contender& best, const Round& round) const;
  const Contender* first_accepted(const Round& round, const std::vector<Round>& so_far) const;
  bool accepted(const Contender* best, const Round& round, const std::vector<Round>& so_far) const;
  bool pair_accepted(const Round& round, std::size_t rounds_so_far) const;
  std::vector<const Contender*> first_effects(const Round& first) const;
  bool was_here_before(const GapFit& present) const;
  Path grown(Path path);
  Path best_path(const Round& first);
  bool preferred(const Path& one, const Path& other, double clear) const;
  void grow_on(GapSearch& result);
  void let_turns_have_a_gain(GapSearch& result);
  GapFit best_linear_model(const GapSearch& result);
  void size_up(GapSearch& result);

  GapProblem& train_;
  GapProblem& heldout_;
  SearchLimits limits_;
  const FreeRuns& free_runs_;
  const ForEach& for_each_;
  const Progress& progress_;
  Contest contest_;
  GapLook look_;
  GapChecks checks_;
  std::vector<TrialModel> been_at_;  // by all paths
};

// No slope leads from a quick pole to a slow one, nor always from a slow one to one less slow.
std::vector<TrialModel> Search::richer_cores(const TrialModel& present) const {
  std::vector<TrialModel> richer;
  if (present.shape.poles < limits_.most_poles) {
    richer.push_back(present.with_larger_core());
    for (const double lag_s : {0.4, 1.5})
      richer.push_back(present.with_larger_core(std::exp(-present.period_s / lag_s)));
  }
  if (present.shape.shared) {
    if (!present.shape.skewed) richer.push_back(present.with_skewed_core());
    richer.push_back(present.with_parted_core());
  }
  // A body is not turned as it is pushed. That it also turns with another gain than it drives is for counts
  // to tell, or for let_turns_have_a_gain.
  const auto crossings =
      train_.has_counts() ? std::vector{Crossing::share, Crossing::free} : std::vector{Crossing::balanced};
  for (const Crossing crossing : crossings) {
    if (crossing > present.shape.crossing) richer.push_back(present.with_crossed_core(crossing));
  }
  return richer;
}

// A richer linear core is a rival too: it wins where what is missing is linear. Only those that promise
// something after a few steps are fitted to the end.
std::optional<GapFit> Search::better_core(const Round& round) const {
  constexpr double promising = 0.3;  // of what the best effect explains
  constexpr int steps_to_the_end = 60;
  const Part part = train_.part_of(EffectStage::command);
  std::optional<GapFit> best;
  double best_score = round.contenders.empty() ? 0.0 : std::max(0.0, round.contenders.front().score);
  const double least_nats = promising * best_score;
  for (const TrialModel& start : richer_cores(round.without.model)) {
    const GapFit first = train_.fit(start, steps_of_a_refit, part);
    if (0.5 * (round.without.squares - first.squares) <= least_nats) continue;
    GapFit fit = train_.fit(first.model, steps_to_the_end, part);
    const double score = contest_.core_score(round, fit);
    if (score <= best_score) continue;
    best_score = score;
    best = std::move(fit);
  }
  return best;
}

Round Search::first_round(const TrialModel& start) {
  Round round = look_.look(look_.settle(start, 3));
  while (const auto larger = better_core(round)) round = look_.look(look_.settle(larger->model, 1));
  return round;
}

// Where free runs are off by more than noise, something is missing: a further effect may be small beside the
// first one, and need not be clear where free runs come closer by it.
bool Search::helps_what_is_off(const Contender& best, const Round& round) const {
  if (!contest_.good_enough(best) || !free_runs_.still_off(round.without.model)) return false;
  return contest_.clear(best) || free_runs_.closer(round.without.model, best.fit.model);
}

bool Search::accepted(const Contender* best, const Round& round, const std::vector<Round>& so_far) const {
  if (best == nullptr || so_far.size() >= limits_.most_effects) return false;
  if (!contest_.worth_adding(*best, so_far) && !helps_what_is_off(*best, round)) return false;
  if (best == round.contenders.data()) return true;
  TrialModel with_both = round.contenders.front().fit.model;
  with_both.effects.push_back(best->effect);
  return contest_.stands_beside(train_.fit(with_both, steps_of_a_fit), round.contenders.front());
}

// Mostly the best one; where correlation leaves that in doubt, the next may be clear.
const Contender* Search::first_accepted(const Round& round, const std::vector<Round>& so_far) const {
  constexpr int few = 3;
  int looked_at = 0;
  for (const Contender& contender : round.contenders) {
    if (is_decoy(*contender.effect.info)) continue;
    if (contender.score <= 0.0 || ++looked_at > few) return nullptr;
    if (accepted(&contender, round, so_far)) return &contender;
  }
  return nullptr;
}

// Paths that took up the same effects one after the other in another order meet, and go on alike.
bool Search::was_here_before(const GapFit& present) const {
  constexpr double same = 5e-4;  // of the squares
  const auto sorted_infos_of = [](const TrialModel& model) {
    auto infos = infos_of(model);
    std::ranges::sort(infos);
    return infos;
  };
  const auto infos = sorted_infos_of(present.model);
  return std::ranges::any_of(been_at_, [&](const TrialModel& before) {
    return sorted_infos_of(before) == infos &&
           squares_of(train_.residuals(before)) < (1.0 + same) * present.squares;
  });
}

// From the model of a path, one effect after the other, until none is worth adding, or another path is met.
Path Search::grown(Path path) {
  for (;;) {
    path.met_another = was_here_before(path.model);
    if (path.met_another) return path;
    been_at_.push_back(path.model.model);
    progress_("effect " + std::to_string(path.rounds.size() + 1),
              0.1 + 0.15 * static_cast<double>(path.rounds.size()));
    Round round = look_.look(path.model);
    while (const auto larger = better_core(round)) round = look_.look(look_.settle(larger->model, 1));
    const Contender* next = first_accepted(round, path.rounds);
    const bool pair = next == nullptr && pair_accepted(round, path.rounds.size());
    path.model = next != nullptr ? look_.with_core_afresh(next->fit)
                 : pair          ? look_.with_core_afresh(*round.pair)
                                 : round.without;
    const bool ends = next == nullptr && !pair;
    path.rounds.push_back(std::move(round));
    if (ends) return path;
  }
}

bool Search::pair_accepted(const Round& round, std::size_t rounds_so_far) const {
  return round.pair && rounds_so_far < limits_.most_effects && contest_.pair_worth_adding(*round.pair, round);
}

// The best one of each name that could be the first.
std::vector<const Contender*> Search::first_effects(const Round& first) const {
  std::vector<const Contender*> all;
  const Contender* best = best_named(first);
  if (!accepted(best, first, {})) return all;
  for (const auto& contender : first.contenders) {
    const bool known = std::ranges::any_of(
        all, [&](const Contender* other) { return other->effect.info == contender.effect.info; });
    if (known || is_decoy(*contender.effect.info) || !contest_.good_enough(contender)) continue;
    if (contender.score < limits_.least_path_score * best->score) break;
    all.push_back(&contender);
    if (all.size() == limits_.most_paths) break;
  }
  return all;
}

// What comes first decides what comes next: each path is gone to its end, and whole models are compared.
Path Search::best_path(const Round& first) {
  std::vector<Path> paths;
  for (const Contender* contender : first_effects(first)) {
    Path path = grown({{first}, look_.with_core_afresh(look_.settle(contender->fit.model, 1))});
    if (path.met_another) continue;
    paths.push_back(std::move(path));
    // One effect and nothing left: whoever else could be it is asked in the checks.
    const TrialModel& found = paths.front().model.model;
    if (found.effects.size() == 1 && !free_runs_.still_off(found)) return std::move(paths.front());
  }
  if (pair_accepted(first, 0)) {
    Path path = grown({{first}, look_.with_core_afresh(look_.settle(first.pair->model, 1))});
    if (!path.met_another) paths.push_back(std::move(path));
  }
  if (paths.empty()) return {{first}, first.without};
  if (paths.size() == 1) return std::move(paths.front());
  const auto closest =
      std::ranges::min_element(paths, {}, [](const Path& path) { return path.model.squares; });
  look_.set_noise_left_by(closest->model.model);
  for_each_(paths.size(),
            [&](std::size_t i) { paths[i].model = train_.fit(paths[i].model.model, steps_of_a_refit); });
  const GapFit nothing = train_.fit(first.without.model, steps_of_a_refit);
  const double all = contest_.advantage(paths.front().model, nothing);
  const double clear = std::max(limits_.least_further_nats, limits_.least_share * all);
  std::size_t best = 0;
  for (std::size_t i = 1; i < paths.size(); ++i) {
    if (preferred(paths[i], paths[best], clear)) best = i;
  }
  return std::move(paths[best]);
}

// Of two models that explain about the same, the one with fewer effects.
bool Search::preferred(const Path& one, const Path& other, double clear) const {
  const std::size_t effects = one.model.model.effects.size();
  const std::size_t others = other.model.model.effects.size();
  const double margin = effects < others ? -clear : effects > others ? clear : 0.0;
  return contest_.advantage(one.model, other.model) > margin;
}

// What did not help beside an effect that has gone since, or found no place for what it masked, may help now.
void Search::grow_on(GapSearch& result) {
  been_at_.clear();
  Path path = grown({result.checks, result.final});
  const auto looks = path.rounds.begin() + static_cast<std::ptrdiff_t>(result.checks.size());
  std::move(looks, path.rounds.end(), std::back_inserter(result.rounds));
  if (path.model.model.effects.size() == result.final.model.effects.size()) return;
  result.final = std::move(path.model);
  checks_.check(result);
}

// Without counts, wheels that do not feel each other have one gain for driving and for turning. That turning
// has another may have several causes; where none of them was found, the core takes it, so that no turn is
// foretold by the gain of driving.
void Search::let_turns_have_a_gain(GapSearch& result) {
  const TrialModel& found = result.final.model;
  if (train_.has_counts() || found.effects.empty()) return;
  const Crossing with_gain = found.shape.crosses_by_weights() ? Crossing::free : Crossing::share;
  GapFit crossed = train_.fit(found.with_crossed_core(with_gain), steps_of_a_refit);
  if (contest_.advantage(crossed, result.final) < limits_.least_core_nats) return;
  if (free_runs_.closer(found, crossed.model)) result.final = std::move(crossed);
}

// The core of the model found, alone, or the one with which the search began: fits of what lacks an effect
// end in many places.
GapFit Search::best_linear_model(const GapSearch& result) {
  TrialModel linear = result.final.model;
  linear.effects.clear();
  GapFit of_found = look_.with_core_afresh(train_.fit(linear, steps_of_a_fit));
  const TrialModel& first = result.rounds.front().without.model;
  if (!first.effects.empty()) return of_found;
  GapFit of_first = train_.fit(first, steps_of_a_fit);
  return of_first.squares < of_found.squares ? of_first : of_found;
}

void Search::size_up(GapSearch& result) {
  result.final = look_.settle(result.final.model, 1);
  result.final = train_.fit(with_steps_centred(train_, result.final.model, for_each_), steps_of_a_refit);
  result.final = away_from_flat_places(train_, result.final, steps_of_a_refit);
  FitWithIntervals known =
      with_effect_intervals(train_, std::move(result.final), steps_of_a_refit, for_each_);
  result.final = std::move(known.fit);
  result.intervals = std::move(known.intervals);
  result.baseline = best_linear_model(result);
  std::vector<const EffectInfo*> named;
  for (const EffectInfo* info : look_.absent_from(result.final.model)) {
    if (!is_decoy(*info)) named.push_back(info);
  }
  result.last_look = screen(train_, result.final, named, for_each_);
  for (const auto& run : train_.runs()) result.train_rolled_m.push_back(run.rolled_before_m);
  for (const auto& run : heldout_.runs()) result.heldout_rolled_m.push_back(run.rolled_before_m);
  result.heldout_squares_before = squares_of(heldout_.residuals(result.baseline.model));
  result.heldout_squares_after = squares_of(heldout_.residuals(result.final.model));
}

GapSearch Search::run(const TrialModel& start) {
  GapSearch result;
  progress_("linear model", 0.0);
  Path path = best_path(first_round(start));
  result.final = std::move(path.model);
  result.rounds = std::move(path.rounds);
  progress_("rivals", 0.75);
  const std::vector<const EffectInfo*> before = infos_of(result.final.model);
  checks_.swap_while_better(result);
  if (infos_of(result.final.model) != before) grow_on(result);
  while (checks_.drop_idle(result)) checks_.check(result);
  let_turns_have_a_gain(result);
  progress_("what would have shown", 0.92);
  size_up(result);
  return result;
}

}  // namespace

GapSearch search_gap(GapProblem& train, GapProblem& heldout, const TrialModel& start,
                     std::span<const EffectInfo* const> candidates, const SearchLimits& limits,
                     const FreeRuns& free_runs, const ForEach& for_each, const Progress& progress) {
  return Search(train, heldout, candidates, limits, free_runs, for_each, progress).run(start);
}

}  // namespace wheelwright::gap
