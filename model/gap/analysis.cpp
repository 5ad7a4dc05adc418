#include "model/gap/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/conclusion/acceptance.hpp"
#include "model/gap/conclusion/check_verdict.hpp"
#include "model/gap/conclusion/confirmation.hpp"
#include "model/gap/conclusion/found_model.hpp"
#include "model/gap/conclusion/linear_verdict.hpp"
#include "model/gap/conclusion/verdict.hpp"
#include "model/gap/figures/free_run_figures.hpp"
#include "model/gap/fit/reference_alignment.hpp"
#include "model/gap/selection/search_start.hpp"
#include "model/prediction/wheel_misfit.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::uint64_t floor_seed = 1;
constexpr std::size_t max_regimes = 6;

class Analysis {
 public:
  Analysis(const GapOptions& options, const ParallelFor& parallel_for, const Progress& progress)
      : options_(options), parallel_for_(parallel_for), progress_(progress) {}

  tl::expected<GapAnalysis, GapRefusal> run(std::span<const DriveLog> train, std::span<const DriveLog> test);

 private:
  void search();
  void note_references_by(const TrialModel& model);
  void conclude();
  void take_back_names();
  void judge();
  void describe_where();
  void size_up();
  void show_gap_with_lost_counts();
  GapFigures figures(const RobotModel& before, const RobotModel& after,
                     const std::vector<DriveLog>& logs) const;
  Score slow_floor(const std::vector<DriveLog>& logs) const;
  Excess over_credible_noise(const std::vector<DriveLog>& logs) const;
  void put_slow_noise_into_floors();
  bool closes_the_gap() const;
  bool leave_out_linear_effects();
  std::vector<std::size_t> runs_off_by_more_than_noise() const;
  void hold_out_others();
  void compare_linear_part();
  void compare_with(const RobotModel& simulation);
  RunSet every_run() const;
  void meet_test_runs();
  void check_on_test_runs();
  void show_untouched_figures();
  void bound_floors();
  void state_noise();
  void note_runs();

  const GapOptions& options_;
  const ParallelFor& parallel_for_;
  const Progress& progress_;
  GatheredRuns gathered_;
  ModelOrigin origin_;
  std::optional<Problem> train_problem_;
  std::optional<Problem> test_problem_;
  Testability testability_;
  bool linear_left_out_ = false;
  GapAnalysis result_;
};

void Analysis::search() {
  train_problem_.emplace(gathered_.train.runs, gathered_.train.metres_per_tick, parallel_for_);
  test_problem_.emplace(gathered_.test.runs, gathered_.test.metres_per_tick, parallel_for_);
  const FreeRuns free_runs{
      [this](const TrialModel& trial) {
        if (trial.shape.gyro_scaled) note_references_by(trial);  // its drift is that beside this model
        const RobotModel model = whole_model_of(trial, origin_);
        const GapFigures train = figures(model, model, gathered_.train.logs);
        const GapFigures test = result_.tail_held_out ? train : figures(model, model, gathered_.test.logs);
        return largest_excess(train, test).times >= more_than_noise;
      },
      [this](const TrialModel& without, const TrialModel& with) {
        if (with.shape.gyro_scaled) note_references_by(with);
        const auto& logs = result_.tail_held_out ? gathered_.train.logs : gathered_.test.logs;
        return shows(figures(whole_model_of(without, origin_), whole_model_of(with, origin_), logs));
      }};
  const TrialModel start = search_start(*train_problem_, origin_.given);
  note_references_by(start);
  auto candidate_effects = testability_.candidate_effects;
  if (linear_left_out_) std::erase_if(candidate_effects, [](const EffectInfo* info) { return info->linear; });
  result_.search = search_gap(*train_problem_, *test_problem_, start, candidate_effects, options_.limits,
                              free_runs, parallel_for_, progress_);
  note_references_by(result_.search.final.model);
  for (std::size_t r = 0; r < gathered_.train.logs.size(); ++r) {
    gathered_.train.logs[r].initial_travel_m = result_.search.train_rolled_m[r];
  }
  for (std::size_t r = 0; r < gathered_.test.logs.size(); ++r) {
    gathered_.test.logs[r].initial_travel_m = result_.search.heldout_rolled_m[r];
  }
}

void Analysis::note_references_by(const TrialModel& model) {
  for (auto* runs : {&gathered_.train, &gathered_.test}) {
    for (std::size_t r = 0; r < runs->logs.size(); ++r) note_references(runs->logs[r], runs->runs[r], model);
  }
}

GapFigures Analysis::figures(const RobotModel& before, const RobotModel& after,
                             const std::vector<DriveLog>& logs) const {
  return {gap_size(before, logs), gap_size(after, logs),
          noise_floor(after, logs, train_problem_->noise(), floor_seed)};
}

Score Analysis::slow_floor(const std::vector<DriveLog>& logs) const {
  const NoiseModel noise = with_slow_noise(*train_problem_, result_.search.final.model, two_seconds_apart_s);
  return noise_floor(result_.after, logs, noise, floor_seed);
}

// Noise over half a second, for a place that is passed within seconds must not be taken for noise; nor must
// what robots of which nothing is missing do not do.
Excess Analysis::over_credible_noise(const std::vector<DriveLog>& logs) const {
  const NoiseModel noise =
      with_slow_noise(*train_problem_, result_.search.final.model, half_a_second_apart_s);
  const GapFigures figures{gap_size(result_.before, logs), gap_size(result_.after, logs),
                           noise_floor(result_.after, logs, no_more_than_noise(noise), floor_seed)};
  return largest_excess(figures, figures);
}

void Analysis::put_slow_noise_into_floors() {
  result_.train.floor = slow_floor(gathered_.train.logs);
  if (!result_.tail_held_out) result_.test.floor = slow_floor(gathered_.test.logs);
}

// Linear effects alone have to show above noise over seconds, too: what drifts slowly, a delay may follow.
// So has what chance may do: it does it to figures that noise over seconds makes as large.
bool Analysis::closes_the_gap() const {
  if (!gap::closes_the_gap(result_, linear_left_out_)) return false;
  const auto& effects = result_.search.final.model.effects;
  const bool linear = std::ranges::all_of(effects, [](const TrialEffect& e) { return e.info->linear; });
  if (!linear && is_beyond_chance(result_)) return true;
  const GapFigures& figures = result_.tail_held_out ? result_.train : result_.test;
  const auto& logs = result_.tail_held_out ? gathered_.train.logs : gathered_.test.logs;
  const GapFigures above_slow_noise{figures.before, figures.after, slow_floor(logs)};
  return linear ? shows(above_slow_noise) : some_figure_falls(above_slow_noise, min_fall, 1.0);
}

void Analysis::describe_where() {
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
  result_.where = regimes(*train_problem_, before.model, before.residuals, after, max_regimes);
}

void Analysis::size_up() {
  result_.before = options_.model ? *options_.model : linear_model_of(result_.search.baseline.model, origin_);
  result_.after = found_model_of(result_.search.final.model, result_.found, origin_);
  result_.train = figures(result_.before, result_.after, gathered_.train.logs);
  if (!result_.tail_held_out) {
    result_.test = figures(result_.before, result_.after, gathered_.test.logs);
  }
}

// Counts are lost at random, so that no simulation predicts them; to know where is what closes their gap.
void Analysis::show_gap_with_lost_counts() {
  result_.train.before = gap_size_with_lost_counts(result_.before, gathered_.train.logs);
  if (!result_.tail_held_out) {
    result_.test.before = gap_size_with_lost_counts(result_.before, gathered_.test.logs);
  }
}

// A linear effect that is no more than a better linear model may stand before one that is: the search is made
// again without it. False where there is none to leave out.
bool Analysis::leave_out_linear_effects() {
  const auto& effects = result_.search.final.model.effects;
  const bool linear = std::ranges::any_of(effects, [](const TrialEffect& e) { return e.info->linear; });
  if (!linear || linear_left_out_) return false;
  linear_left_out_ = true;
  search();
  return true;
}

void Analysis::conclude() {
  result_.found = findings_of(result_.search);
  double longest_run_s = 0.0;
  for (const GapRun& run : gathered_.train.runs) longest_run_s = std::max(longest_run_s, run.duration_s());
  add_rivals_that_cannot_show(result_.found, testability_.untestable, longest_run_s);
  if (auto dropout = dropout_finding(gathered_.dropouts, gathered_.watched_s)) {
    result_.found.insert(result_.found.begin(), *std::move(dropout));
  }
  size_up();
  const bool any = !result_.search.final.model.effects.empty();
  const bool nothing_closes = any && !closes_the_gap();
  // A short delay alone is one parameter in the place of several of a linear part that could hold it.
  const bool of_a_linear_part =
      any && std::ranges::all_of(result_.search.final.model.effects, [](const TrialEffect& effect) {
        return effect.info->linear && !beyond_a_linear_part(effect);
      });
  if ((nothing_closes || of_a_linear_part) && leave_out_linear_effects()) return conclude();
  if (nothing_closes) take_back_names();
  judge();
}

void Analysis::take_back_names() {
  std::erase_if(result_.found, [](const Finding& found) { return found.setting.name != dropout_name; });
  result_.search.final = result_.search.baseline;
  size_up();
}

void Analysis::judge() {
  ResidualDiagnostics residual{what_is_left(result_), {}, train_problem_->has_counts()};
  put_slow_noise_into_floors();
  residual.gain_changes = changed_gains(result_, *train_problem_, *test_problem_);
  reach_verdict(result_, options_.limits, residual);
  describe_where();
  const auto dropout = [](const Finding& found) { return found.setting.name == dropout_name; };
  if (std::ranges::any_of(result_.found, dropout)) show_gap_with_lost_counts();
  result_.not_testable = testability_.untestable;
  std::erase_if(result_.not_testable, [this](const Untestable& untestable) {
    return std::ranges::any_of(result_.found,
                               [&](const Finding& found) { return found.setting.name == untestable.effect; });
  });
  const double autocorrelation_factor = 1.5;  // what is usual of a search that ended well
  result_.detectable =
      detectable_sizes(result_.search.last_look, testability_.excitation, options_.limits.min_train_nats,
                       autocorrelation_factor, result_.not_testable);
}

// Of the training, the one furthest off first.
std::vector<std::size_t> Analysis::runs_off_by_more_than_noise() const {
  std::vector<std::pair<double, std::size_t>> off;
  for (std::size_t r = 0; r < gathered_.train.logs.size(); ++r) {
    const double times = over_credible_noise({gathered_.train.logs[r]}).times;
    if (times >= more_than_noise) off.emplace_back(times, r);
  }
  std::ranges::sort(off, std::greater<>{});
  std::vector<std::size_t> runs;
  runs.reserve(off.size());
  for (const auto& [times, run] : off) runs.push_back(run);
  return runs;
}

// What shows in runs of the training alone (a place that no other run visits) cannot be confirmed by those
// that are held out: one in which it shows is held out in their place, where another is left to find it in.
void Analysis::hold_out_others() {
  if (result_.verdict != Verdict::nothing_missing || result_.tail_held_out) return;
  if (over_credible_noise(gathered_.train.logs).times < more_than_noise) return;
  const auto off = runs_off_by_more_than_noise();
  if (off.size() < 2) return;
  const GapAnalysis first = result_;
  const GatheredRuns gathered = gathered_;
  // The run that shows it the most is the best to find it in.
  for (const std::size_t run : {off[1], off[std::min<std::size_t>(2, off.size() - 1)], off[0]}) {
    gathered_ = gathered;
    while (!gathered_.test.runs.empty()) gathered_.test.move_to(gathered_.train, 0);
    gathered_.train.move_to(gathered_.test, run);
    note_runs();
    linear_left_out_ = false;
    search();
    conclude();
    if (result_.found.empty()) continue;
    result_.summary += " The runs that were to be held out do not show it: " + result_.held_out.front() +
                       " was held out in their place.";
    return;
  }
  result_ = first;
  gathered_ = gathered;
  note_runs();
  train_problem_.emplace(gathered_.train.runs, gathered_.train.metres_per_tick, parallel_for_);
  test_problem_.emplace(gathered_.test.runs, gathered_.test.metres_per_tick, parallel_for_);
  const NoiseModel noise = train_problem_->noise_left_by(result_.search.final.model);
  train_problem_->set_noise(noise);
  test_problem_->set_noise(noise);
  if (largest_excess(first.train, first.train).times < far_above_noise) return;
  result_.verdict = Verdict::unnamed;
  result_.summary = "Something is missing in " + std::to_string(off.size()) +
                    " of the training runs that no held-out run shows and no effect of the library explains.";
  const double share = 1.0 / static_cast<double>(gathered.train.runs.size());
  for (const std::size_t run : off) {
    result_.where.push_back({"run " + gathered.train.runs[run].name, share, share});
  }
}

void Analysis::compare_linear_part() {
  if (!options_.model) return;
  if (!add_linear_changes(result_, origin_, *train_problem_, *test_problem_)) return;
  result_.train.after = gap_size(result_.after, gathered_.train.logs);
  if (!result_.tail_held_out) result_.test.after = gap_size(result_.after, gathered_.test.logs);
}

// Once the names stand: they are judged beside a linear model, since the simulation may have them too.
void Analysis::compare_with(const RobotModel& simulation) {
  const ModelOrigin origin{&simulation, origin_.logs};
  const LinearChanges changes = changes_of_linear_part(result_, origin, *train_problem_, *test_problem_);
  result_.linear_changes = changes.changes;
  result_.linear_gain_nats = changes.heldout_gain_nats;
  result_.before = simulation;
  result_.train.before = gap_size(simulation, gathered_.train.logs);
  const RunSet& test = result_.untouched ? gathered_.untouched : gathered_.test;
  if (!result_.tail_held_out) result_.test.before = gap_size(simulation, test.logs);
}

RunSet Analysis::every_run() const {
  RunSet all = gathered_.train;
  for (const RunSet* more : {&gathered_.test, &gathered_.untouched}) {
    for (std::size_t r = 0; r < more->runs.size(); ++r) all.add(more->runs[r], more->logs[r]);
  }
  return all;
}

// What was accepted meets the runs that nothing was chosen by; where there are none, those that were held
// out.
void Analysis::meet_test_runs() {
  RunSet& untouched = gathered_.untouched;
  result_.untouched = !untouched.runs.empty();
  RunSet& test = result_.untouched ? untouched : gathered_.test;
  for (std::size_t r = 0; r < test.logs.size(); ++r) {
    note_references(test.logs[r], test.runs[r], result_.search.final.model);
  }
  const bool any_effect = !result_.search.final.model.effects.empty();
  RunSet all = any_effect ? RunSet{} : every_run();
  const Confirmation confirmation =
      confirm(*train_problem_, result_.search, any_effect ? test : all, result_.untouched, parallel_for_);
  result_.check = confirmation.check;
  result_.checked = !any_effect         ? CheckedRuns::all
                    : result_.untouched ? CheckedRuns::untouched
                                        : CheckedRuns::held_out;
  const auto& effects = result_.search.final.model.effects;
  for (std::size_t i = 0; i < confirmation.effect_nats.size(); ++i) {
    const auto found = std::ranges::find_if(
        result_.found, [&](const Finding& one) { return one.setting.name == effects[i].info->name; });
    if (found == result_.found.end()) continue;
    found->test_gain_nats = confirmation.effect_nats[i];
    found->acts_untouched = confirmation.acts[i];
  }
  show_untouched_figures();
}

// Names that do not pass there are taken back, and the model without them meets the same runs.
void Analysis::check_on_test_runs() {
  meet_test_runs();
  const bool something_is_left = explains_the_smaller_part(result_);
  if (result_.linear_changes.empty() && (something_is_left || closes_nothing_untouched(result_))) {
    const std::string part = something_is_left ? part_in_words(result_) : not_seen_in_words(result_);
    take_back_names();
    judge();
    meet_test_runs();
    apply_check(result_);
    if (result_.verdict == Verdict::nothing_missing && something_is_left) {
      result_.verdict = Verdict::unnamed;
      result_.summary = "Something is missing that no effect of the library explains.";
    }
    result_.summary += part;
    return;
  }
  apply_check(result_);
}

// Figures of the held-out runs have served in the choice of effects.
void Analysis::show_untouched_figures() {
  if (!result_.untouched) return;
  const RunSet& untouched = gathered_.untouched;
  result_.tested.clear();
  for (const GapRun& run : untouched.runs) result_.tested.push_back(run.name);
  result_.test = figures(result_.before, result_.after, untouched.logs);
  result_.test.floor = slow_floor(untouched.logs);
}

void Analysis::bound_floors() {
  for (GapFigures* figures : {&result_.train, &result_.test})
    figures->floor = bounded_floor(figures->floor, figures->after);
}

void Analysis::note_runs() {
  result_.train_runs = gathered_.train.runs.size();
  result_.test_runs = gathered_.test.runs.size();
  origin_ = {options_.model ? &*options_.model : nullptr, {}};
  for (const auto& log : gathered_.train.logs) origin_.logs.push_back(log.name);
  result_.trained = origin_.logs;
  result_.held_out.clear();
  for (const auto& run : gathered_.test.runs) result_.held_out.push_back(run.name);
  result_.tested = result_.held_out;
}

// What a filter by the model has to know of it.
void Analysis::state_noise() {
  if (result_.after.linear_part.left.from_left.empty()) return;
  const auto fits = wheel_misfit(result_.after, gathered_.train.logs);
  if (!fits) return;
  result_.after.left_fit = fits->left;
  result_.after.right_fit = fits->right;
}

tl::expected<GapAnalysis, GapRefusal> Analysis::run(std::span<const DriveLog> train,
                                                    std::span<const DriveLog> test) {
  if (auto refusal = gather_runs(train, test, options_.period_s, gathered_)) return tl::unexpected(*refusal);
  testability_ = testability(gathered_.to_learn_from);
  result_.data_faults = gathered_.faults;
  result_.tail_held_out = gathered_.tail_held_out;
  note_runs();
  if (data_decide(result_, gathered_.train, testability_)) return result_;
  search();
  conclude();
  hold_out_others();
  compare_linear_part();
  check_on_test_runs();
  if (options_.simulation) compare_with(*options_.simulation);
  bound_floors();
  state_noise();
  if (options_.model)
    result_.summary += not_compared_in_words(*options_.model, gathered_.train.runs.front().period_s);
  return result_;
}

}  // namespace

tl::expected<GapAnalysis, GapRefusal> analyse_gap(std::span<const DriveLog> train,
                                                  std::span<const DriveLog> test, const GapOptions& options,
                                                  const ParallelFor& parallel_for, const Progress& progress) {
  return Analysis(options, parallel_for, progress).run(train, test);
}

}  // namespace wheelwright::gap
