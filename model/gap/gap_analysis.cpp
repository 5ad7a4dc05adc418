#include "model/gap/gap_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "model/effect_library.hpp"
#include "model/gap/decoys.hpp"
#include "model/gap/gap_size.hpp"
#include "model/gap/parameter_intervals.hpp"

namespace wheelwright::gap {
namespace {

constexpr double least_run_s = 5.0;
constexpr double smallest_p = 1e-300;  // a chance of zero is never claimed
constexpr double sure = 0.9;           // posterior from which on a name stands
constexpr std::uint64_t floor_seed = 1;
constexpr std::size_t most_regimes = 6;

struct Runs {
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;
  std::vector<DriveLog> logs;  // as the gate left them

  void add(GapRun run, const DriveLog& log) {
    runs.push_back(std::move(run));
    metres_per_tick.push_back(log.metres_per_tick.value_or(WheelPair{}));
    logs.push_back(log);
  }
};

class Analysis {
 public:
  Analysis(const GapOptions& options, const ForEach& for_each, const Progress& progress)
      : options_(options), for_each_(for_each), progress_(progress) {}

  tl::expected<GapAnalysis, GapRefusal> run(std::span<const DriveLog> train, std::span<const DriveLog> test);

 private:
  std::optional<GapRefusal> mismatch(std::span<const DriveLog> logs) const;
  void gate_all(std::span<const DriveLog> logs, Runs& runs);
  std::optional<GapRefusal> hold_out();
  bool nothing_to_see();
  TrialModel start();
  void search();
  void conclude();
  void mention_wheel_angles();
  void add_dropouts();
  void describe_where();
  void size_up();
  Finding finding(std::size_t index) const;
  RobotModel model_of(const TrialModel& trial, bool with_effects) const;
  void set_verdict();
  bool runs_differ();
  bool closes_the_gap() const;

  const GapOptions& options_;
  const ForEach& for_each_;
  const Progress& progress_;
  Runs train_;
  Runs test_;
  std::vector<Dropout> dropouts_;
  double watched_s_ = 0.0;
  std::optional<GapProblem> train_problem_;
  std::optional<GapProblem> test_problem_;
  Testability testability_;
  GapAnalysis result_;
};

std::optional<GapRefusal> Analysis::mismatch(std::span<const DriveLog> logs) const {
  const DriveLog& first = logs.front();
  for (const auto& log : logs) {
    const std::string where = log.name + ":" + std::to_string(log.first_line) + ": ";
    if (log.samples.size() < 20 || log.samples.back().t_s - log.samples.front().t_s < least_run_s) {
      return GapRefusal{
          where + "the run lasts " + std::to_string(log.samples.back().t_s - log.samples.front().t_s) +
          " s, but at least " + std::to_string(static_cast<int>(least_run_s)) + " s are needed"};
    }
    if (std::abs(log.period_s - first.period_s) > 0.02 * first.period_s) {
      return GapRefusal{where + "its period is " + std::to_string(log.period_s) + " s, but that of " +
                        first.name + " is " + std::to_string(first.period_s) + " s; analyse them apart"};
    }
    if (std::abs(log.wheel_base_m - first.wheel_base_m) > 1e-6) {
      return GapRefusal{where + "its wheel base is " + std::to_string(log.wheel_base_m) + " m, but that of " +
                        first.name + " is " + std::to_string(first.wheel_base_m) +
                        " m; are they of the same robot?"};
    }
    if (log.has_ticks() != first.has_ticks()) {
      return GapRefusal{
          where + (log.has_ticks() ? "it holds encoder counts, but " : "it holds no encoder counts, but ") +
          first.name + (first.has_ticks() ? " does" : " does not") + "; analyse them apart"};
    }
  }
  return std::nullopt;
}

void Analysis::gate_all(std::span<const DriveLog> logs, Runs& runs) {
  for (const auto& log : logs) {
    GatedLog gated = gate(log);
    result_.data_faults.insert(result_.data_faults.end(), gated.faults.begin(), gated.faults.end());
    dropouts_.insert(dropouts_.end(), gated.dropouts.begin(), gated.dropouts.end());
    watched_s_ += log.samples.back().t_s - log.samples.front().t_s;
    GapRun run = make_gap_run(gated.log, gated.flags, log.period_s);
    measure_motion(run);
    runs.add(std::move(run), gated.log);
  }
}

// Whole runs where there are several: the last third of them, at least one.
std::optional<GapRefusal> Analysis::hold_out() {
  if (!test_.runs.empty()) return std::nullopt;
  const std::size_t count = train_.runs.size();
  if (count > 1) {
    for (std::size_t kept = count - std::max<std::size_t>(1, count / 3); kept < train_.runs.size();) {
      test_.add(train_.runs[kept], train_.logs[kept]);
      train_.runs.erase(train_.runs.begin() + static_cast<std::ptrdiff_t>(kept));
      train_.logs.erase(train_.logs.begin() + static_cast<std::ptrdiff_t>(kept));
      train_.metres_per_tick.erase(train_.metres_per_tick.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    return std::nullopt;
  }
  const GapRun whole = train_.runs.front();
  if (whole.duration_s() < 3.0 * least_run_s) {
    return GapRefusal{whole.name + ": a single run of " + std::to_string(whole.duration_s()) +
                      " s is too short to hold a part of it out; give at least " +
                      std::to_string(static_cast<int>(3.0 * least_run_s)) + " s or a second run"};
  }
  const std::size_t cut = whole.commands_m_s.size() * 2 / 3;
  train_.runs.front() = part_of(whole, 0, cut);
  test_.add(part_of(whole, cut, whole.commands_m_s.size() + 1), train_.logs.front());
  result_.tail_held_out = true;
  return std::nullopt;
}

bool Analysis::nothing_to_see() {
  const bool faulty = std::ranges::any_of(result_.data_faults, &DataFault::explains);
  if (faulty) {
    result_.verdict = Verdict::bad_data;
    result_.summary = "The data contradict themselves: " +
                      std::ranges::find_if(result_.data_faults, &DataFault::explains)->what + ".";
    return true;
  }
  double largest = 0.0;
  for (const auto& run : train_.runs) {
    for (const auto& u : run.commands_m_s) largest = std::max({largest, std::abs(u.left), std::abs(u.right)});
  }
  const bool seen = std::ranges::any_of(train_.runs, [](const GapRun& run) {
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
  const GapRun& run = train_.runs.front();
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
  train_problem_.emplace(train_.runs, train_.metres_per_tick, for_each_);
  test_problem_.emplace(test_.runs, test_.metres_per_tick, for_each_);
  result_.search = search_gap(*train_problem_, *test_problem_, start(), testability_.candidates,
                              options_.limits, for_each_, progress_);
  for (std::size_t r = 0; r < train_.logs.size(); ++r) {
    train_.logs[r].rolled_before_m = result_.search.train_rolled_m[r];
  }
  for (std::size_t r = 0; r < test_.logs.size(); ++r) {
    test_.logs[r].rolled_before_m = result_.search.heldout_rolled_m[r];
  }
}

RobotModel Analysis::model_of(const TrialModel& trial, bool with_effects) const {
  RobotModel model;
  if (options_.model) {
    model.robot = options_.model->robot;
    model.encoder_scale = options_.model->encoder_scale;
  }
  for (const auto& log : train_.logs) model.source.push_back(log.name);
  model.core = trial.linear();
  if (!with_effects) return model;
  for (const auto& found : result_.found) {
    AddedEffect added;
    added.setting = found.setting;
    added.intervals = found.intervals;
    added.source = model.source;
    added.heldout_gain_nats = found.heldout_gain_nats;
    added.p_value = found.p_value;
    model.effects.push_back(std::move(added));
  }
  return model;
}

// Probability of each name in the place of an accepted effect, the others being there.
Finding Analysis::finding(std::size_t index) const {
  const GapSearch& search = result_.search;
  Finding found;
  found.setting = search.final.model.settings()[index];
  if (index >= search.checks.size()) return found;
  std::map<std::string, double> best_score;
  const auto& contenders = search.checks[index].contenders;
  for (const auto& contender : contenders) {
    const std::string name = is_decoy(*contender.effect.info) ? "decoy" : contender.effect.info->name;
    const auto entry = best_score.try_emplace(name, contender.score).first;
    entry->second = std::max(entry->second, contender.score);
    if (name == found.setting.name && found.heldout_gain_nats == 0.0) {
      found.heldout_gain_nats = contender.heldout_nats / contender.inflation;
      found.p_value = std::clamp(std::exp(-found.heldout_gain_nats), smallest_p, 1.0);
    }
  }
  double largest = 0.0;  // the score of adding nothing
  for (const auto& [name, score] : best_score) largest = std::max(largest, score);
  double sum = std::exp(-largest);
  for (const auto& [name, score] : best_score) sum += std::exp(score - largest);
  for (const auto& [name, score] : best_score) {
    const double posterior = std::exp(score - largest) / sum;
    if (name == found.setting.name) {
      found.posterior = posterior;
    } else {
      found.rivals.push_back({name, posterior});
    }
  }
  std::ranges::sort(found.rivals, std::greater<>{}, &Rival::posterior);
  return found;
}

// Counts that stood still are an effect of the library, but one that the data gate finds.
void Analysis::add_dropouts() {
  if (dropouts_.empty() || watched_s_ <= 0.0) return;
  double lost_s = 0.0;
  for (const auto& dropout : dropouts_) lost_s += dropout.duration_s;
  Finding found;
  found.setting = {"encoder_dropout",
                   "",
                   {std::min(1.0, lost_s / watched_s_), lost_s / static_cast<double>(dropouts_.size())}};
  const double share = found.setting.parameters[0];
  const double relative = 1.96 / std::sqrt(static_cast<double>(dropouts_.size()));
  found.intervals = {{share * std::max(0.0, 1.0 - relative), std::min(1.0, share * (1.0 + relative))},
                     {found.setting.parameters[1] * std::max(0.0, 1.0 - relative),
                      found.setting.parameters[1] * (1.0 + relative)}};
  // Each one alone is impossible for a wheel that turns, so what is left of doubt is whether it turned.
  found.heldout_gain_nats = 5.0 * static_cast<double>(dropouts_.size());
  found.p_value = std::exp(-found.heldout_gain_nats);
  found.posterior = 1.0 - found.p_value;
  result_.found.push_back(std::move(found));
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
  result_.verdict = Verdict::nothing_missing;
  result_.summary = "Nothing is missing that these runs could show.";
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
  for (const auto& run : test_.runs) {
    const double gain = travel_gain(result_.search.final.model, run);
    if (std::abs(gain - 1.0) < least_change) continue;
    changes += (changes.empty() ? "" : ", ") + run.name + " by " +
               std::to_string(static_cast<int>(std::lround(1000.0 * (gain - 1.0)))) + " per mille";
    result_.where.push_back({"run " + run.name, 1.0 / static_cast<double>(test_.runs.size()),
                             1.0 / static_cast<double>(test_.runs.size())});
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
  } else if (result_.verdict == Verdict::unnamed && result_.where.empty()) {
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
  result_.train = figures(train_.logs);
  if (!result_.tail_held_out) result_.test = figures(test_.logs);
}

// What is named has to show where a person looks: some figure of the held-out free runs must fall.
bool Analysis::closes_the_gap() const {
  constexpr double least_fall = 0.03;
  const GapFigures& figures = result_.tail_held_out ? result_.train : result_.test;
  // A linear effect is no more than a better linear model, unless the gap was one to be seen above the noise.
  constexpr double above_noise = 1.15;
  const auto& effects = result_.search.final.model.effects;
  const bool linear =
      std::ranges::all_of(effects, [](const TrialEffect& effect) { return effect.info->linear; });
  const auto falls = [&](const std::optional<double>& before, const std::optional<double>& after,
                         const std::optional<double>& floor) {
    if (!before || !after || (linear && floor && *before < above_noise * *floor)) return false;
    return *after < (1.0 - least_fall) * *before;
  };
  const auto value = [](const std::optional<AtHorizon>& figure) -> std::optional<double> {
    return figure ? std::optional(figure->value) : std::nullopt;
  };
  const auto& [before, after, floor] = figures;
  return falls(before.wheel_speed_rms_m_s, after.wheel_speed_rms_m_s, floor.wheel_speed_rms_m_s) ||
         falls(before.distance_rms_m, after.distance_rms_m, floor.distance_rms_m) ||
         falls(value(before.position_rms_m), value(after.position_rms_m), value(floor.position_rms_m)) ||
         falls(value(before.heading_rms_rad), value(after.heading_rms_rad), value(floor.heading_rms_rad));
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

void Analysis::conclude() {
  add_dropouts();
  const auto intervals = parameter_intervals(*train_problem_, result_.search.final);
  std::size_t parameter = result_.search.final.model.core.size();
  for (std::size_t i = 0; i < result_.search.final.model.effects.size(); ++i) {
    Finding found = finding(i);
    const std::size_t count = found.setting.parameters.size();
    found.intervals.assign(intervals.begin() + static_cast<std::ptrdiff_t>(parameter),
                           intervals.begin() + static_cast<std::ptrdiff_t>(parameter + count));
    parameter += count;
    result_.found.push_back(std::move(found));
  }
  size_up();
  if (!result_.search.final.model.effects.empty() && !closes_the_gap()) {
    std::erase_if(result_.found,
                  [](const Finding& found) { return found.setting.name != "encoder_dropout"; });
    result_.search.final = result_.search.baseline;
    size_up();
  }
  set_verdict();
  mention_wheel_angles();
  describe_where();
  result_.not_testable = testability_.untestable;
  const double inflation = 1.5;  // what is usual of a search that ended well
  result_.detectable = detectable_sizes(result_.search.last_look, options_.limits.least_train_nats, inflation,
                                        result_.not_testable);
}

tl::expected<GapAnalysis, GapRefusal> Analysis::run(std::span<const DriveLog> train,
                                                    std::span<const DriveLog> test) {
  std::vector<DriveLog> all(train.begin(), train.end());
  all.insert(all.end(), test.begin(), test.end());
  if (auto refusal = mismatch(all)) return tl::unexpected(*refusal);
  gate_all(train, train_);
  gate_all(test, test_);
  testability_ = testability(train);
  if (auto refusal = hold_out()) return tl::unexpected(*refusal);
  result_.train_runs = train_.runs.size();
  result_.test_runs = test_.runs.size();
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
