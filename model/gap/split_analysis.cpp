#include "model/gap/split_analysis.hpp"

#include <algorithm>
#include <utility>

#include "model/gap/conclusion/acceptance.hpp"
#include "model/gap/conclusion/linear_verdict.hpp"
#include "model/gap/conclusion/verdict.hpp"
#include "model/gap/figures/free_run_figures.hpp"
#include "model/gap/fit/reference_alignment.hpp"
#include "model/gap/selection/candidate_evaluation.hpp"
#include "model/gap/selection/search_start.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::uint64_t floor_seed = 1;
constexpr std::size_t max_regimes = 6;

std::vector<std::string> names_of(const RunSet& runs) {
  std::vector<std::string> names;
  for (const GapRun& run : runs.runs) names.push_back(run.name);
  return names;
}

}  // namespace

GapAnalysis analysis_before_search(const GatheredRuns& runs) {
  GapAnalysis analysis;
  analysis.data_faults = runs.faults;
  analysis.tail_held_out = runs.tail_held_out;
  analysis.train_runs = runs.train.runs.size();
  analysis.test_runs = runs.test.runs.size();
  for (const DriveLog& log : runs.train.logs) analysis.trained.push_back(log.name);
  analysis.held_out = names_of(runs.test);
  analysis.tested = analysis.held_out;
  return analysis;
}

SplitAnalysis::SplitAnalysis(GatheredRuns runs, const AnalysisContext& context)
    : context_(context), runs_(std::move(runs)), result_(analysis_before_search(runs_)) {
  origin_ = {context.options.model ? &*context.options.model : nullptr, result_.trained};
  search();
  conclude();
}

void SplitAnalysis::withdraw_names() {
  remove_names();
  judge();
}

void SplitAnalysis::withdraw(const std::vector<std::string>& names) {
  fit_without(names);
  judge();
}

void SplitAnalysis::fit_without(const std::vector<std::string>& names) {
  GapSearch& search = result_.search;
  TrialModel rest = search.final.model;
  for (std::size_t i = rest.effects.size(); i-- > 0;) {
    if (std::ranges::find(names, rest.effects[i].info->name) == names.end()) continue;
    rest.effects.erase(rest.effects.begin() + static_cast<std::ptrdiff_t>(i));
    if (i < search.checks.size()) search.checks.erase(search.checks.begin() + static_cast<std::ptrdiff_t>(i));
  }
  FitWithIntervals known = with_effect_intervals(*train_, train_->fit(rest, steps_of_a_refit),
                                                 steps_of_a_refit, context_.parallel_for);
  search.final = std::move(known.fit);
  search.intervals = std::move(known.intervals);
  take_findings();
}

void SplitAnalysis::search() {
  train_.emplace(runs_.train.runs, runs_.train.metres_per_tick, context_.parallel_for);
  held_out_.emplace(runs_.test.runs, runs_.test.metres_per_tick, context_.parallel_for);
  const FreeRuns free_runs{
      [this](const TrialModel& trial) {
        if (trial.shape.gyro_scaled) note_references_by(trial);  // its drift is that beside this model
        const RobotModel model = whole_model_of(trial, origin_);
        const GapFigures train = figures(model, model, runs_.train.logs);
        const GapFigures test = result_.tail_held_out ? train : figures(model, model, runs_.test.logs);
        return largest_excess(train, test).times >= more_than_noise;
      },
      [this](const TrialModel& without, const TrialModel& with) {
        if (with.shape.gyro_scaled) note_references_by(with);
        const auto& logs = result_.tail_held_out ? runs_.train.logs : runs_.test.logs;
        return shows(figures(whole_model_of(without, origin_), whole_model_of(with, origin_), logs));
      }};
  const TrialModel start = search_start(*train_, origin_.given);
  note_references_by(start);
  auto candidate_effects = context_.testability.candidate_effects;
  if (linear_left_out_) std::erase_if(candidate_effects, [](const EffectInfo* info) { return info->linear; });
  result_.search = search_gap(*train_, *held_out_, start, candidate_effects, context_.options.limits,
                              free_runs, context_.parallel_for, context_.progress);
  note_references_by(result_.search.final.model);
  for (std::size_t r = 0; r < runs_.train.logs.size(); ++r) {
    runs_.train.logs[r].initial_travel_m = result_.search.train_rolled_m[r];
  }
  for (std::size_t r = 0; r < runs_.test.logs.size(); ++r) {
    runs_.test.logs[r].initial_travel_m = result_.search.heldout_rolled_m[r];
  }
}

void SplitAnalysis::note_references_by(const TrialModel& model) {
  for (auto* runs : {&runs_.train, &runs_.test}) {
    for (std::size_t r = 0; r < runs->logs.size(); ++r) note_references(runs->logs[r], runs->runs[r], model);
  }
}

GapFigures SplitAnalysis::figures(const RobotModel& before, const RobotModel& after,
                                  const std::vector<DriveLog>& logs) const {
  return {gap_size(before, logs), gap_size(after, logs),
          noise_floor(after, logs, train_->noise(), floor_seed)};
}

Score SplitAnalysis::slow_floor(const std::vector<DriveLog>& logs) const {
  const NoiseModel noise = with_slow_noise(*train_, result_.search.final.model, two_seconds_apart_s);
  return noise_floor(result_.after, logs, noise, floor_seed);
}

// Noise over half a second, for a place that is passed within seconds must not be taken for noise; nor must
// what robots of which nothing is missing do not do.
Excess SplitAnalysis::over_credible_noise(const std::vector<DriveLog>& logs) const {
  const NoiseModel noise = with_slow_noise(*train_, result_.search.final.model, half_a_second_apart_s);
  const GapFigures figures{gap_size(result_.before, logs), gap_size(result_.after, logs),
                           noise_floor(result_.after, logs, with_bounded_drift(noise), floor_seed)};
  return largest_excess(figures, figures);
}

void SplitAnalysis::put_slow_noise_into_floors() {
  result_.train.floor = slow_floor(runs_.train.logs);
  if (!result_.tail_held_out) result_.test.floor = slow_floor(runs_.test.logs);
}

// Linear effects alone have to show above noise over seconds, too: what drifts slowly, a short delay may
// follow. So has what chance may do: it does it to figures that noise over seconds makes as large.
bool SplitAnalysis::closes_the_gap() const {
  if (context_.options.names_small_effects && is_beyond_chance(result_)) return true;
  if (!gap::closes_the_gap(result_, linear_left_out_)) return false;
  const auto& effects = result_.search.final.model.effects;
  const bool linear = std::ranges::all_of(effects, [](const TrialEffect& e) { return e.info->linear; });
  if (!linear && is_beyond_chance(result_)) return true;
  const GapFigures& figures = result_.tail_held_out ? result_.train : result_.test;
  const auto& logs = result_.tail_held_out ? runs_.train.logs : runs_.test.logs;
  const GapFigures above_slow_noise{figures.before, figures.after, slow_floor(logs)};
  if (linear) return shows(above_slow_noise) || has_long_delay_beyond_doubt(result_);
  return some_figure_falls(above_slow_noise, min_fall, 1.0);
}

void SplitAnalysis::describe_where() {
  const GapSearch& search = result_.search;
  const Fit& before = search.baseline;
  std::vector<double> after;
  if (!search.final.model.effects.empty()) {
    after = search.final.residuals;
  } else if (result_.verdict == Verdict::unnamed && result_.where.empty() &&
             !search.selection_steps.back().candidates.empty()) {
    after = search.selection_steps.back().candidates.front().fit.residuals;
  } else {
    return;
  }
  result_.where = regimes(*train_, before.model, before.residuals, after, max_regimes);
}

void SplitAnalysis::size_up() {
  result_.before = context_.options.model ? *context_.options.model
                                          : linear_model_of(result_.search.baseline.model, origin_);
  result_.after = found_model_of(result_.search.final.model, result_.found, origin_);
  result_.train = figures(result_.before, result_.after, runs_.train.logs);
  if (!result_.tail_held_out) {
    result_.test = figures(result_.before, result_.after, runs_.test.logs);
  }
}

// Counts are lost at random, so that no simulation predicts them; to know where is what closes their gap.
void SplitAnalysis::show_gap_with_lost_counts() {
  result_.train.before = gap_size_with_lost_counts(result_.before, runs_.train.logs);
  if (!result_.tail_held_out) {
    result_.test.before = gap_size_with_lost_counts(result_.before, runs_.test.logs);
  }
}

// A linear effect that is no more than a better linear model may stand before one that is: the search is made
// again without it. False where there is none to leave out.
bool SplitAnalysis::leave_out_linear_effects() {
  const auto& effects = result_.search.final.model.effects;
  const bool linear = std::ranges::any_of(effects, [](const TrialEffect& e) { return e.info->linear; });
  if (!linear || linear_left_out_) return false;
  linear_left_out_ = true;
  search();
  return true;
}

// A short delay alone is one parameter in the place of several of a linear part that could hold it; and one
// whose interval reaches down to there is no longer for sure.
bool SplitAnalysis::is_of_a_linear_part() const {
  const TrialModel& model = result_.search.final.model;
  const auto at_least = [&](TrialEffect effect) {
    const auto found = std::ranges::find_if(
        result_.found, [&](const Finding& one) { return one.setting.name == effect.info->name; });
    if (found != result_.found.end() && !found->intervals.empty())
      effect.parameters.front() = found->intervals.front().lower;
    return effect;
  };
  return !model.effects.empty() && std::ranges::all_of(model.effects, [&](const TrialEffect& effect) {
    return effect.info->linear && !beyond_a_linear_part(model, at_least(effect));
  });
}

void SplitAnalysis::take_findings() {
  result_.found = findings_of(result_.search);
  double longest_run_s = 0.0;
  for (const GapRun& run : runs_.train.runs) longest_run_s = std::max(longest_run_s, run.duration_s());
  add_rivals_that_cannot_show(result_.found, context_.testability.untestable, longest_run_s);
  if (auto dropout = dropout_finding(runs_.dropouts, runs_.watched_s)) {
    result_.found.insert(result_.found.begin(), *std::move(dropout));
  }
  size_up();
}

void SplitAnalysis::conclude() {
  take_findings();
  const std::vector<std::string> sizeless = names_without_size(result_.found);
  const std::size_t effects = result_.search.final.model.effects.size();
  const bool some_remain = sizeless.size() < effects;
  if (!sizeless.empty() && some_remain) fit_without(sizeless);
  const bool nothing_closes = effects > 0 && (!some_remain || !closes_the_gap());
  if ((nothing_closes || is_of_a_linear_part()) && leave_out_linear_effects()) return conclude();
  if (nothing_closes) remove_names();
  judge();
}

void SplitAnalysis::remove_names() {
  std::erase_if(result_.found, [](const Finding& found) { return found.setting.name != dropout_name; });
  result_.search.final = result_.search.baseline;
  size_up();
}

void SplitAnalysis::judge() {
  ResidualDiagnostics residual{residual_excess(result_), {}, train_->has_counts()};
  put_slow_noise_into_floors();
  residual.gain_changes = changed_gains(result_, *train_, *held_out_);
  reach_verdict(result_, context_.options.limits, residual);
  describe_where();
  const auto dropout = [](const Finding& found) { return found.setting.name == dropout_name; };
  if (std::ranges::any_of(result_.found, dropout)) show_gap_with_lost_counts();
  result_.not_testable = context_.testability.untestable;
  std::erase_if(result_.not_testable, [this](const Untestable& untestable) {
    return std::ranges::any_of(result_.found,
                               [&](const Finding& found) { return found.setting.name == untestable.effect; });
  });
  const double autocorrelation_factor = 1.5;  // what is usual of a search that ended well
  result_.detectable =
      detectable_sizes(result_.search.last_look, context_.testability.excitation,
                       context_.options.limits.min_train_nats, autocorrelation_factor, result_.not_testable);
}

}  // namespace wheelwright::gap
