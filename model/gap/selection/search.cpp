#include "model/gap/selection/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/flat_parameters.hpp"
#include "model/gap/candidates/quantization_search.hpp"
#include "model/gap/selection/candidate_acceptance.hpp"
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
  std::vector<SelectionStep> selection_steps;
  Fit model;
  bool met_another = false;  // which goes on from here
};

class Search {
 public:
  Search(FitProblem& train, FitProblem& heldout, std::span<const EffectInfo* const> candidate_effects,
         const SearchLimits& limits, const FreeRuns& free_runs, const ParallelFor& parallel_for,
         const Progress& progress)
      : train_(train),
        heldout_(heldout),
        limits_(limits),
        free_runs_(free_runs),
        parallel_for_(parallel_for),
        progress_(progress),
        comparison_(train, heldout, limits_),
        evaluation_(train, heldout, comparison_, candidate_effects, limits_, parallel_for),
        acceptance_(train, comparison_, limits_, free_runs),
        checks_(train, comparison_, evaluation_, limits_, free_runs) {}

  GapSearch run(const TrialModel& start);

 private:
  SelectionStep first_round(const TrialModel& start);
  TrialModel with_balanced_modes(const TrialModel& present) const;
  std::vector<TrialModel> higher_order_parts(const TrialModel& present) const;
  std::optional<Fit> better_linear_part(const SelectionStep& selection_step) const;
  bool was_here_before(const Fit& present) const;
  bool pair_found(SelectionStep& selection_step, std::size_t steps_so_far);
  Path grown(Path path);
  Path best_path(SelectionStep first);
  bool preferred(const Path& one, const Path& other, double clear) const;
  void grow_on(GapSearch& result);
  void let_turns_have_a_gain(GapSearch& result);
  Fit best_linear_model(const GapSearch& result);
  void size_up(GapSearch& result);

  FitProblem& train_;
  FitProblem& heldout_;
  SearchLimits limits_;
  const FreeRuns& free_runs_;
  const ParallelFor& parallel_for_;
  const Progress& progress_;
  ModelComparison comparison_;
  CandidateEvaluation evaluation_;
  CandidateAcceptance acceptance_;
  RivalChecks checks_;
  std::vector<TrialModel> been_at_;  // by all paths
};

// No slope leads to two modes of one gain from one mode: what the travel gains, the last weight of turns
// loses. By way of gains of their own it does.
TrialModel Search::with_balanced_modes(const TrialModel& present) const {
  const Outputs outputs = train_.outputs_of(EffectStage::command);
  const TrialModel modes = present.with_cross_coupling(CrossCoupling::modes);
  return train_.fit(modes, steps_of_a_refit, outputs)
      .model.with_cross_coupling(CrossCoupling::balanced_modes);
}

// No slope leads from a quick pole to a slow one, nor always from a slow one to one less slow.
std::vector<TrialModel> Search::higher_order_parts(const TrialModel& present) const {
  std::vector<TrialModel> richer;
  if (present.shape.poles < limits_.max_poles) {
    richer.push_back(present.with_higher_order());
    for (const double lag_s : {0.4, 1.5})
      richer.push_back(present.with_higher_order(std::exp(-present.period_s / lag_s)));
  }
  if (present.shape.shared) {
    if (!present.shape.unequal_lags) richer.push_back(present.with_unequal_lags());
    richer.push_back(present.with_parted_linear_part());
  } else {
    // The fit of one wheel may have ended in a place that is not the best, and that of the other not.
    for (const WheelSide wheel : {WheelSide::left, WheelSide::right})
      richer.push_back(present.with_response_of(wheel));
  }
  // A body is not turned as it is pushed. That it also turns with another gain than it drives is for counts
  // to tell, or for let_turns_have_a_gain.
  using enum CrossCoupling;
  const auto cross_couplings =
      train_.has_counts() ? std::vector{share, lag, free, modes} : std::vector{lag, balanced, balanced_modes};
  for (const CrossCoupling cross_coupling : cross_couplings) {
    if (cross_coupling > present.shape.cross_coupling)
      richer.push_back(cross_coupling == balanced_modes ? with_balanced_modes(present)
                                                        : present.with_cross_coupling(cross_coupling));
  }
  return richer;
}

// A richer linear part is a rival too: it wins where what is missing is linear. Only those that
// promise something after a few steps are fitted to the end.
std::optional<Fit> Search::better_linear_part(const SelectionStep& selection_step) const {
  constexpr double promising = 0.3;  // of what the best effect explains
  constexpr int steps_to_the_end = 60;
  const Outputs outputs = train_.outputs_of(EffectStage::command);
  std::optional<Fit> best;
  double best_score =
      selection_step.candidates.empty() ? 0.0 : std::max(0.0, selection_step.candidates.front().score);
  const double min_nats = promising * best_score;
  for (const TrialModel& start : higher_order_parts(selection_step.without.model)) {
    const Fit first = train_.fit(start, steps_of_a_refit, outputs);
    if (0.5 * (selection_step.without.sum_squares - first.sum_squares) <= min_nats) continue;
    Fit fit = train_.fit(first.model, steps_to_the_end, outputs);
    const double score = comparison_.core_score(selection_step, fit);
    if (score <= best_score) continue;
    best_score = score;
    best = std::move(fit);
  }
  return best;
}

SelectionStep Search::first_round(const TrialModel& start) {
  SelectionStep selection_step = evaluation_.evaluate(evaluation_.settle(start, 3));
  while (const auto larger = better_linear_part(selection_step))
    selection_step = evaluation_.evaluate(evaluation_.settle(larger->model, 1));
  return selection_step;
}

// Paths that took up the same effects one after the other in another order meet, and go on alike.
bool Search::was_here_before(const Fit& present) const {
  constexpr double same = 5e-4;  // of the squares
  const auto sorted_infos_of = [](const TrialModel& model) {
    auto infos = infos_of(model);
    std::ranges::sort(infos);
    return infos;
  };
  const auto infos = sorted_infos_of(present.model);
  return std::ranges::any_of(been_at_, [&](const TrialModel& before) {
    return sorted_infos_of(before) == infos &&
           sum_squares_of(train_.residuals(before)) < (1.0 + same) * present.sum_squares;
  });
}

// The pair that was screened, or else the best two that help.
bool Search::pair_found(SelectionStep& selection_step, std::size_t steps_so_far) {
  if (steps_so_far >= limits_.max_effects) return false;
  if (acceptance_.pair_accepted(selection_step, steps_so_far)) return true;
  evaluation_.pair_the_best(selection_step);
  return acceptance_.pair_accepted(selection_step, steps_so_far);
}

// From the model of a path, one effect after the other, until none is worth adding, or another path is met.
Path Search::grown(Path path) {
  for (;;) {
    path.met_another = was_here_before(path.model);
    if (path.met_another) return path;
    been_at_.push_back(path.model.model);
    progress_("effect " + std::to_string(path.selection_steps.size() + 1),
              0.1 + 0.15 * static_cast<double>(path.selection_steps.size()));
    SelectionStep selection_step = evaluation_.evaluate(path.model);
    while (const auto larger = better_linear_part(selection_step))
      selection_step = evaluation_.evaluate(evaluation_.settle(larger->model, 1));
    const Candidate* next = acceptance_.next_effect(selection_step, path.selection_steps);
    const bool pair = next == nullptr && pair_found(selection_step, path.selection_steps.size());
    path.model = next != nullptr ? evaluation_.with_refitted_linear_part(next->fit)
                 : pair          ? evaluation_.with_refitted_linear_part(*selection_step.pair)
                                 : selection_step.without;
    const bool ends = next == nullptr && !pair;
    path.selection_steps.push_back(std::move(selection_step));
    if (ends) return path;
  }
}

// What comes first decides what comes next: each path is gone to its end, and whole models are compared.
Path Search::best_path(SelectionStep first) {
  std::vector<Path> paths;
  const std::vector<const Candidate*> first_effects = acceptance_.first_effects(first);
  const bool by_pair = first_effects.empty() ? pair_found(first, 0) : acceptance_.pair_accepted(first, 0);
  for (const Candidate* candidate : first_effects) {
    Path path =
        grown({{first}, evaluation_.with_refitted_linear_part(evaluation_.settle(candidate->fit.model, 1))});
    if (path.met_another) continue;
    paths.push_back(std::move(path));
    // One effect and nothing left: whoever else could be it is asked in the checks.
    const TrialModel& found = paths.front().model.model;
    if (found.effects.size() == 1 && !free_runs_.still_off(found)) return std::move(paths.front());
  }
  if (by_pair) {
    Path path =
        grown({{first}, evaluation_.with_refitted_linear_part(evaluation_.settle(first.pair->model, 1))});
    if (!path.met_another) paths.push_back(std::move(path));
  }
  if (paths.empty()) return {{first}, first.without};
  if (paths.size() == 1) return std::move(paths.front());
  const auto closest =
      std::ranges::min_element(paths, {}, [](const Path& path) { return path.model.sum_squares; });
  evaluation_.set_noise_left_by(closest->model.model);
  parallel_for_(paths.size(),
                [&](std::size_t i) { paths[i].model = train_.fit(paths[i].model.model, steps_of_a_refit); });
  const Fit nothing = train_.fit(first.without.model, steps_of_a_refit);
  const double all = comparison_.advantage(paths.front().model, nothing);
  const double clear = std::max(limits_.min_further_nats, limits_.min_share * all);
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
  return comparison_.advantage(one.model, other.model) > margin;
}

// What did not help beside an effect that has gone since, or found no place for what it masked, may help now.
void Search::grow_on(GapSearch& result) {
  been_at_.clear();
  Path path = grown({result.checks, result.final});
  const auto looks = path.selection_steps.begin() + static_cast<std::ptrdiff_t>(result.checks.size());
  std::move(looks, path.selection_steps.end(), std::back_inserter(result.selection_steps));
  if (path.model.model.effects.size() == result.final.model.effects.size()) return;
  result.final = std::move(path.model);
  checks_.check(result);
}

// Without counts, wheels that do not feel each other have one gain for driving and for turning. That turning
// has another may have several causes; where none of them was found, the linear part takes it, so that no
// turn is predicted by the gain of driving.
void Search::let_turns_have_a_gain(GapSearch& result) {
  const TrialModel& found = result.final.model;
  if (train_.has_counts() || found.effects.empty()) return;
  const CrossCoupling with_gain =
      found.shape.cross_coupling == CrossCoupling::none ? CrossCoupling::share : CrossCoupling::free;
  Fit crossed = train_.fit(found.with_cross_coupling(with_gain), steps_of_a_refit);
  if (comparison_.advantage(crossed, result.final) < limits_.min_linear_part_nats) return;
  if (free_runs_.closer(found, crossed.model)) result.final = std::move(crossed);
}

// The linear part of the model found, alone, or the one with which the search began: fits of what lacks an
// effect end in many places.
Fit Search::best_linear_model(const GapSearch& result) {
  TrialModel linear = result.final.model;
  linear.effects.clear();
  Fit of_found = evaluation_.with_refitted_linear_part(train_.fit(linear, steps_of_a_fit));
  const TrialModel& first = result.selection_steps.front().without.model;
  if (!first.effects.empty()) return of_found;
  Fit of_first = train_.fit(first, steps_of_a_fit);
  return of_first.sum_squares < of_found.sum_squares ? of_first : of_found;
}

void Search::size_up(GapSearch& result) {
  result.final = evaluation_.settle(result.final.model, 1);
  result.final = train_.fit(with_steps_centred(train_, result.final.model, parallel_for_), steps_of_a_refit);
  result.final = away_from_flat_parameters(train_, result.final, steps_of_a_refit);
  FitWithIntervals known =
      with_effect_intervals(train_, std::move(result.final), steps_of_a_refit, parallel_for_);
  result.final = std::move(known.fit);
  result.intervals = std::move(known.intervals);
  result.baseline = best_linear_model(result);
  std::vector<const EffectInfo*> named;
  for (const EffectInfo* info : evaluation_.absent_from(result.final.model)) {
    if (!is_decoy(*info)) named.push_back(info);
  }
  result.last_look = screen(train_, result.final, named, parallel_for_);
  for (const auto& run : train_.runs()) result.train_rolled_m.push_back(run.initial_travel_m);
  for (const auto& run : heldout_.runs()) result.heldout_rolled_m.push_back(run.initial_travel_m);
  result.heldout_sum_squares_before = sum_squares_of(heldout_.residuals(result.baseline.model));
  result.heldout_sum_squares_after = sum_squares_of(heldout_.residuals(result.final.model));
}

GapSearch Search::run(const TrialModel& start) {
  GapSearch result;
  progress_("linear model", 0.0);
  Path path = best_path(first_round(start));
  result.final = std::move(path.model);
  result.selection_steps = std::move(path.selection_steps);
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

GapSearch search_gap(FitProblem& train, FitProblem& heldout, const TrialModel& start,
                     std::span<const EffectInfo* const> candidate_effects, const SearchLimits& limits,
                     const FreeRuns& free_runs, const ParallelFor& parallel_for, const Progress& progress) {
  return Search(train, heldout, candidate_effects, limits, free_runs, parallel_for, progress).run(start);
}

}  // namespace wheelwright::gap
