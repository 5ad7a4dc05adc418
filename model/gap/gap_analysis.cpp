#include "model/gap/gap_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "model/effect_library.hpp"
#include "model/gap/decoys.hpp"
#include "model/gap/gap_size.hpp"

namespace wheelwright::gap {
namespace {

constexpr double sure = 0.9;             // posterior from which on a name stands
constexpr double more_than_noise = 1.5;  // of a figure, in noise floors; clean logs stay below 1.15
constexpr double far_above_noise = 2.0;
constexpr double nowhere_near = 6.0;
constexpr std::string_view dropout_name = "encoder_dropout";
constexpr std::uint64_t floor_seed = 1;
constexpr std::size_t most_regimes = 6;

std::string in_words(const Excess& excess) {
  const auto tenths = std::lround(10.0 * excess.times);
  return std::string(excess.figure) + " is off " + std::to_string(tenths / 10) + "." +
         std::to_string(tenths % 10) + " times as far as by noise alone";
}

class Analysis {
 public:
  Analysis(const GapOptions& options, const ForEach& for_each, const Progress& progress)
      : options_(options), for_each_(for_each), progress_(progress) {}

  tl::expected<GapAnalysis, GapRefusal> run(std::span<const DriveLog> train, std::span<const DriveLog> test);

 private:
  bool nothing_to_see();
  TrialModel start();
  void search();
  void conclude();
  void mention_wheel_angles();
  void describe_where();
  void size_up();
  RobotModel model_of(const TrialModel& trial, bool with_effects) const;
  void set_verdict();
  bool runs_differ();
  bool gap_remains();
  bool closes_the_gap() const;
  Excess what_is_left() const;
  bool leaves_most_of_it() const;
  void mention_what_is_left();
  bool leave_out_linear_effects();

  const GapOptions& options_;
  const ForEach& for_each_;
  const Progress& progress_;
  GatheredRuns gathered_;
  std::optional<GapProblem> train_problem_;
  std::optional<GapProblem> test_problem_;
  Testability testability_;
  bool linear_left_out_ = false;
  GapAnalysis result_;
};

bool Analysis::nothing_to_see() {
  const bool faulty = std::ranges::any_of(result_.data_faults, &DataFault::explains);
  if (faulty) {
    result_.verdict = Verdict::bad_data;
    result_.summary = "The data contradict themselves: " +
                      std::ranges::find_if(result_.data_faults, &DataFault::explains)->what + ".";
    return true;
  }
  double largest = 0.0;
  for (const auto& run : gathered_.train.runs) {
    for (const auto& u : run.commands_m_s) largest = std::max({largest, std::abs(u.left), std::abs(u.right)});
  }
  const bool seen = std::ranges::any_of(gathered_.train.runs, [](const GapRun& run) {
    return run.has_counts || (run.references.size() > 50 && !run.sparse);
  });
  if (largest > 0.005 && seen) return false;
  result_.verdict = Verdict::not_testable;
  result_.summary =
      largest > 0.005
          ? "The logs hold no encoder counts, and reference poses too rarely to show how the wheels answer; "
            "record counts, or a pose at least three times a second."
          : "The robot was never told to move in these runs.";
  for (const EffectInfo* info : testability_.candidates) {
    if (is_decoy(*info)) continue;
    result_.not_testable.push_back({info->name, largest > 0.005
                                                    ? "no encoder counts and too few reference poses"
                                                    : "the robot was never told to move"});
  }
  return true;
}

TrialModel Analysis::start() {
  const GapRun& run = gathered_.train.runs.front();
  CoreShape shape;
  shape.shared = !train_problem_->has_counts();
  // A core that reaches back 90 ms holds what delay is usual of a serial line and a motor; more of it is an
  // effect.
  shape.weights = static_cast<std::size_t>(std::clamp(std::lround(0.09 / run.period_s) + 1, 3L, 10L));
  TrialModel best;
  double least = 0.0;
  for (const double lag_s : {0.06, 0.15}) {
    TrialModel guess = first_guess(shape, run.period_s, run.wheel_base_m, lag_s, 0.036);
    if (options_.model) {
      for (const auto& effect : options_.model->effects) {
        const EffectInfo* info = find_effect(effect.setting.name);
        guess.effects.push_back(
            {info, variant_index(*info, effect.setting.variant), effect.setting.parameters});
      }
    }
    train_problem_->set_noise({});
    const GapFit fit = train_problem_->fit(guess, 8);
    if (best.core.empty() || fit.squares < least) {
      best = fit.model;
      least = fit.squares;
    }
  }
  return best;
}

void Analysis::search() {
  train_problem_.emplace(gathered_.train.runs, gathered_.train.metres_per_tick, for_each_);
  test_problem_.emplace(gathered_.test.runs, gathered_.test.metres_per_tick, for_each_);
  const auto still_missing = [this](const TrialModel& trial) {
    RobotModel model = model_of(trial, false);
    for (const auto& setting : trial.settings()) model.effects.push_back({setting, {}, {}, {}, {}, {}});
    const auto figures = [&](const std::vector<DriveLog>& logs) {
      return GapFigures{
          {}, gap_size(model, logs), noise_floor(model, logs, train_problem_->noise(), floor_seed)};
    };
    const GapFigures train = figures(gathered_.train.logs);
    return largest_excess(train, result_.tail_held_out ? train : figures(gathered_.test.logs)).times >=
           more_than_noise;
  };
  result_.search = search_gap(*train_problem_, *test_problem_, start(), testability_.candidates,
                              options_.limits, still_missing, for_each_, progress_);
  for (std::size_t r = 0; r < gathered_.train.logs.size(); ++r) {
    gathered_.train.logs[r].rolled_before_m = result_.search.train_rolled_m[r];
  }
  for (std::size_t r = 0; r < gathered_.test.logs.size(); ++r) {
    gathered_.test.logs[r].rolled_before_m = result_.search.heldout_rolled_m[r];
  }
}

RobotModel Analysis::model_of(const TrialModel& trial, bool with_effects) const {
  RobotModel model;
  if (options_.model) {
    model.robot = options_.model->robot;
    model.encoder_scale = options_.model->encoder_scale;
  }
  for (const auto& log : gathered_.train.logs) model.source.push_back(log.name);
  model.core = trial.linear();
  if (!with_effects) return model;
  // In the order in which they act; what the data gate found is put in front.
  const auto add = [&](const Finding& found) {
    AddedEffect added;
    added.setting = found.setting;
    added.intervals = found.intervals;
    added.source = model.source;
    added.heldout_gain_nats = found.heldout_gain_nats;
    added.p_value = found.p_value;
    model.effects.push_back(std::move(added));
  };
  for (const auto& found : result_.found) {
    if (found.setting.name == dropout_name) add(found);
  }
  for (const auto& setting : trial.settings()) {
    for (const auto& found : result_.found) {
      if (found.setting.name == setting.name) add(found);
    }
  }
  return model;
}

void Analysis::set_verdict() {
  const GapSearch& search = result_.search;
  const auto doubtful =
      std::ranges::find_if(result_.found, [](const Finding& found) { return found.posterior < sure; });
  if (doubtful != result_.found.end()) {
    result_.verdict = Verdict::ambiguous;
    result_.summary =
        "Something is missing, but these runs do not tell " + doubtful->setting.name + " from " +
        (doubtful->rivals.empty() ? std::string("others") : doubtful->rivals.front().effect) + ".";
    return;
  }
  if (!result_.found.empty()) {
    result_.verdict = Verdict::named;
    result_.summary = "Missing:";
    for (const auto& found : result_.found) result_.summary += " " + found.setting.name;
    result_.summary += ".";
    return;
  }
  const auto& last = search.rounds.back().contenders;
  const bool structured =
      !last.empty() &&
      last.front().heldout_nats / last.front().inflation > options_.limits.least_heldout_nats &&
      last.front().train_nats / last.front().inflation > options_.limits.least_train_nats;
  if (structured && is_decoy(*last.front().effect.info)) {
    result_.verdict = Verdict::unnamed;
    result_.summary = "Something is missing that no effect of the library explains.";
    return;
  }
  if (runs_differ()) return;
  if (!result_.data_faults.empty() && std::ranges::any_of(result_.data_faults, &DataFault::distorts)) {
    result_.verdict = Verdict::bad_data;
    result_.summary =
        "Faults of the data explain the gap; without those rows nothing is missing that could show.";
    return;
  }
  if (gap_remains()) return;
  result_.verdict = Verdict::nothing_missing;
  result_.summary = "Nothing is missing that these runs could show.";
}

// That no effect was found does not mean that nothing is missing: where the free runs are off by more than
// noise explains, in the runs that were fitted and in those that were not, something is.
bool Analysis::gap_remains() {
  const Excess excess = what_is_left();
  if (excess.times < more_than_noise) return false;
  result_.verdict = Verdict::unnamed;
  result_.summary =
      "Something is missing that no effect of the library explains: in free runs " + in_words(excess) + ".";
  return true;
}

Excess Analysis::what_is_left() const {
  return largest_excess(result_.train, result_.tail_held_out ? result_.train : result_.test);
}

// Whatever helps a little is not what is missing, where free runs stay far off all the same. What explains a
// lot may stand although more is missing.
bool Analysis::leaves_most_of_it() const {
  constexpr double explains_a_lot_nats = 100.0;
  const bool helps_a_little = std::ranges::any_of(result_.found, [](const Finding& found) {
    return found.setting.name != dropout_name && found.heldout_gain_nats < explains_a_lot_nats;
  });
  if (!helps_a_little) return false;
  const Excess left = what_is_left();
  return left.times >= nowhere_near || (left.times >= far_above_noise && left.closed < 0.5);
}

void Analysis::mention_what_is_left() {
  const Excess left = what_is_left();
  if (result_.verdict != Verdict::named || left.times < far_above_noise) return;
  result_.summary += " More may be: in free runs " + in_words(left) + ".";
}

// The held-out runs may be another robot's, or the same one's on another day: a gain that changed between
// runs, whose cause no run shows.
bool Analysis::runs_differ() {
  constexpr double much_worse = 1.5;  // mean square of held-out residuals against those of training
  constexpr double least_change = 0.01;
  const double train = result_.search.final.squares / static_cast<double>(train_problem_->readings());
  const double test = result_.search.heldout_squares_after / static_cast<double>(test_problem_->readings());
  if (test < much_worse * train) return false;
  std::string changes;
  for (const auto& run : gathered_.test.runs) {
    const double gain = travel_gain(result_.search.final.model, run);
    if (std::abs(gain - 1.0) < least_change) continue;
    changes += (changes.empty() ? "" : ", ") + run.name + " by " +
               std::to_string(static_cast<int>(std::lround(1000.0 * (gain - 1.0)))) + " per mille";
    result_.where.push_back({"run " + run.name, 1.0 / static_cast<double>(gathered_.test.runs.size()),
                             1.0 / static_cast<double>(gathered_.test.runs.size())});
  }
  if (changes.empty()) return false;
  result_.verdict = Verdict::unnamed;
  result_.summary =
      "The gain changed between training and held-out runs (" + changes + "); these logs cannot say why.";
  return true;
}

void Analysis::describe_where() {
  const GapSearch& search = result_.search;
  const GapFit& before = search.baseline;
  std::vector<double> after;
  if (!search.final.model.effects.empty()) {
    after = search.final.residuals;
  } else if (result_.verdict == Verdict::unnamed && result_.where.empty() &&
             !search.rounds.back().contenders.empty()) {
    after = search.rounds.back().contenders.front().fit.residuals;
  } else {
    return;
  }
  result_.where = regimes(*train_problem_, before.model, before.residuals, after, most_regimes);
}

void Analysis::size_up() {
  result_.before = options_.model ? *options_.model : model_of(result_.search.baseline.model, false);
  result_.after = model_of(result_.search.final.model, true);
  const NoiseModel& noise = train_problem_->noise();
  const auto figures = [&](const std::vector<DriveLog>& logs) {
    return GapFigures{gap_size(result_.before, logs), gap_size(result_.after, logs),
                      noise_floor(result_.after, logs, noise, floor_seed)};
  };
  result_.train = figures(gathered_.train.logs);
  if (!result_.tail_held_out) result_.test = figures(gathered_.test.logs);
}

// What is named has to show where a person looks, some figure of the held-out free runs must fall; or it has
// to be beyond doubt.
bool Analysis::closes_the_gap() const {
  constexpr double least_fall = 0.03;
  constexpr double beyond_doubt_nats = 30.0;
  const GapFigures& figures = result_.tail_held_out ? result_.train : result_.test;
  // A linear effect is no more than a better linear model, unless the gap was one to be seen above the noise;
  // and what stands in for one that was left out is no more than that.
  constexpr double above_noise = 1.15;
  const auto& effects = result_.search.final.model.effects;
  const bool linear = linear_left_out_ || std::ranges::all_of(effects, [](const TrialEffect& effect) {
                        return effect.info->linear;
                      });
  const auto beyond_doubt = [](const Finding& found) {
    return found.heldout_gain_nats > beyond_doubt_nats && found.posterior > sure;
  };
  if (!linear && std::ranges::any_of(result_.found, beyond_doubt)) return true;
  return some_figure_falls(figures, least_fall, linear ? above_noise : 0.0);
}

// What was found holds for a run whose wheels begin at a known angle: that has to be said.
void Analysis::mention_wheel_angles() {
  const auto& effects = result_.search.final.model.effects;
  const bool rippling =
      std::ranges::any_of(effects, [](const TrialEffect& effect) { return effect.info->by_wheel_angle; });
  const auto apart = [](const WheelPair& way) { return way.left != 0.0 || way.right != 0.0; };
  if (!rippling || std::ranges::none_of(result_.search.train_rolled_m, apart)) return;
  result_.summary +=
      " The wheels began each run at another angle; the figures take the angles that each run showed.";
}

// A linear effect that is no more than a better linear model may stand before one that is: the search is made
// again without it. False where there is none to leave out.
bool Analysis::leave_out_linear_effects() {
  const auto& effects = result_.search.final.model.effects;
  const bool linear = std::ranges::any_of(effects, [](const TrialEffect& e) { return e.info->linear; });
  const auto left_out =
      std::erase_if(testability_.candidates, [](const EffectInfo* info) { return info->linear; });
  if (!linear || left_out == 0) return false;
  linear_left_out_ = true;
  search();
  return true;
}

void Analysis::conclude() {
  result_.found = findings_of(*train_problem_, result_.search);
  if (auto dropout = dropout_finding(gathered_.dropouts, gathered_.watched_s)) {
    result_.found.insert(result_.found.begin(), *std::move(dropout));
  }
  size_up();
  const bool nothing_closes = !result_.search.final.model.effects.empty() && !closes_the_gap();
  if (nothing_closes && leave_out_linear_effects()) return conclude();
  if (nothing_closes || (!result_.search.final.model.effects.empty() && leaves_most_of_it())) {
    std::erase_if(result_.found, [](const Finding& found) { return found.setting.name != dropout_name; });
    result_.search.final = result_.search.baseline;
    size_up();
  }
  set_verdict();
  mention_wheel_angles();
  mention_what_is_left();
  describe_where();
  result_.not_testable = testability_.untestable;
  const double inflation = 1.5;  // what is usual of a search that ended well
  result_.detectable = detectable_sizes(result_.search.last_look, options_.limits.least_train_nats, inflation,
                                        result_.not_testable);
}

tl::expected<GapAnalysis, GapRefusal> Analysis::run(std::span<const DriveLog> train,
                                                    std::span<const DriveLog> test) {
  if (auto refusal = gather_runs(train, test, gathered_)) return tl::unexpected(*refusal);
  testability_ = testability(train);
  result_.data_faults = gathered_.faults;
  result_.tail_held_out = gathered_.tail_held_out;
  result_.train_runs = gathered_.train.runs.size();
  result_.test_runs = gathered_.test.runs.size();
  if (nothing_to_see()) return result_;
  search();
  conclude();
  return result_;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::named:
      return "named";
    case Verdict::nothing_missing:
      return "nothing_missing";
    case Verdict::unnamed:
      return "unnamed";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::not_testable:
      return "not_testable";
    case Verdict::bad_data:
      return "bad_data";
  }
  return "";
}

tl::expected<GapAnalysis, GapRefusal> analyse_gap(std::span<const DriveLog> train,
                                                  std::span<const DriveLog> test, const GapOptions& options,
                                                  const ForEach& for_each, const Progress& progress) {
  return Analysis(options, for_each, progress).run(train, test);
}

}  // namespace wheelwright::gap
