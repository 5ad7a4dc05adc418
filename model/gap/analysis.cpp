#include "model/gap/analysis.hpp"

#include <algorithm>
#include <utility>

#include "model/gap/check_on_test_runs.hpp"
#include "model/gap/conclusion/linear_verdict.hpp"
#include "model/gap/conclusion/verdict.hpp"
#include "model/gap/figures/free_run_figures.hpp"
#include "model/gap/runs/short_name.hpp"
#include "model/gap/selection/search_start.hpp"
#include "model/gap/simulation/needed_differences.hpp"
#include "model/gap/split_analysis.hpp"
#include "model/prediction/wheel_misfit.hpp"

namespace wheelwright::gap {
namespace {

// Of the training, the one furthest off first.
std::vector<std::size_t> runs_off_by_more_than_noise(const SplitAnalysis& analysis) {
  const auto& logs = analysis.runs().train.logs;
  std::vector<std::pair<double, std::size_t>> off;
  for (std::size_t r = 0; r < logs.size(); ++r) {
    const double times = analysis.over_credible_noise({logs[r]}).times;
    if (times >= more_than_noise) off.emplace_back(times, r);
  }
  std::ranges::sort(off, std::greater<>{});
  std::vector<std::size_t> runs;
  runs.reserve(off.size());
  for (const auto& [times, run] : off) runs.push_back(run);
  return runs;
}

GatheredRuns with_held_out(GatheredRuns runs, std::size_t training_run) {
  while (!runs.test.runs.empty()) runs.test.move_to(runs.train, 0);
  runs.train.move_to(runs.test, training_run);
  return runs;
}

void say_that_no_held_out_run_shows_it(SplitAnalysis& analysis, const std::vector<std::size_t>& off) {
  GapAnalysis& result = analysis.result();
  if (largest_excess(result.train, result.train).times < far_above_noise) return;
  result.verdict = Verdict::unnamed;
  result.summary = "Something is missing in " + std::to_string(off.size()) +
                   " of the training runs that no held-out run shows and no effect of the library explains.";
  const auto& runs = analysis.runs().train.runs;
  const double share = 1.0 / static_cast<double>(runs.size());
  for (const std::size_t run : off) result.where.push_back({"run " + short_name(run, runs), share, share});
}

// What shows in runs of the training alone (a place that no other run visits) cannot be confirmed by those
// that are held out: one in which it shows is held out in their place, where another is left to find it in.
SplitAnalysis analysed(GatheredRuns gathered, const AnalysisContext& context) {
  SplitAnalysis first(std::move(gathered), context);
  if (first.result().verdict != Verdict::nothing_missing || first.runs().tail_held_out) return first;
  if (first.over_credible_noise(first.runs().train.logs).times < more_than_noise) return first;
  const auto off = runs_off_by_more_than_noise(first);
  if (off.size() < 2) return first;
  // The run that shows it the most is the best to find it in.
  for (const std::size_t run : {off[1], off[std::min<std::size_t>(2, off.size() - 1)], off[0]}) {
    SplitAnalysis other(with_held_out(first.runs(), run), context);
    if (other.result().found.empty()) continue;
    other.result().summary +=
        " The runs that were to be held out do not show it: " + other.result().held_out.front() +
        " was held out in their place.";
    return other;
  }
  say_that_no_held_out_run_shows_it(first, off);
  return first;
}

void compare_linear_part(SplitAnalysis& analysis) {
  GapAnalysis& result = analysis.result();
  if (!add_linear_changes(result, analysis.origin(), analysis.train(), analysis.held_out())) return;
  result.train.after = gap_size(result.after, analysis.runs().train.logs);
  if (!result.tail_held_out) result.test.after = gap_size(result.after, analysis.runs().test.logs);
}

// Once the names stand: they are judged beside a linear model, since the simulation may have them too.
void compare_with(const RobotModel& simulation, SplitAnalysis& analysis) {
  GapAnalysis& result = analysis.result();
  const ModelOrigin origin{&simulation, analysis.origin().logs};
  const TrialModel& found = result.search.final.model;
  FitProblem train = analysis.train();
  FitProblem held_out = analysis.held_out();
  const NoiseModel noise = train.noise_left_by(found);
  train.set_noise(noise);
  held_out.set_noise(noise);
  NeededDifferences needed = needed_differences(trial_effects_of(simulation), found, train, held_out);
  const LinearChanges changes =
      changes_of_linear_part(needed.model, origin, analysis.train(), analysis.held_out());
  result.differing_effects = std::move(needed.effects);
  result.linear_changes = changes.changes;
  result.linear_gain_nats = changes.heldout_gain_nats;
  result.before = simulation;
  const GatheredRuns& runs = analysis.runs();
  result.train.before = gap_size(simulation, runs.train.logs);
  const RunSet& test = result.untouched ? runs.untouched : runs.test;
  if (!result.tail_held_out) result.test.before = gap_size(simulation, test.logs);
}

void bound_floors(GapAnalysis& result) {
  for (GapFigures* figures : {&result.train, &result.test})
    figures->floor = bounded_floor(figures->floor, figures->after);
}

// What a filter by the model has to know of it.
void state_noise(GapAnalysis& result, const std::vector<DriveLog>& logs) {
  if (result.after.linear_part.left.from_left.empty()) return;
  const auto fits = wheel_misfit(result.after, logs);
  if (!fits) return;
  result.after.left_fit = fits->left;
  result.after.right_fit = fits->right;
}

}  // namespace

tl::expected<GapAnalysis, GapRefusal> analyse_gap(std::span<const DriveLog> train,
                                                  std::span<const DriveLog> test, const GapOptions& options,
                                                  const ParallelFor& parallel_for, const Progress& progress) {
  GatheredRuns gathered;
  if (auto refusal = gather_runs(train, test, options.period_s, gathered)) return tl::unexpected(*refusal);
  const Testability testable = testability(gathered.to_learn_from);
  GapAnalysis by_data = analysis_before_search(gathered);
  if (data_decide(by_data, gathered.train, testable)) return by_data;
  SplitAnalysis analysis = analysed(std::move(gathered), {options, testable, parallel_for, progress});
  if (options.model) compare_linear_part(analysis);
  check_on_test_runs(analysis, parallel_for);
  if (options.simulation) compare_with(*options.simulation, analysis);
  GapAnalysis result = std::move(analysis.result());
  bound_floors(result);
  state_noise(result, analysis.runs().train.logs);
  if (options.model)
    result.summary += not_compared_in_words(*options.model, analysis.runs().train.runs.front().period_s);
  return result;
}

}  // namespace wheelwright::gap
