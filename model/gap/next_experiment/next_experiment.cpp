#include "model/gap/next_experiment/next_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/conclusion/acceptance.hpp"
#include "model/gap/next_experiment/divergence.hpp"
#include "model/log/near_periods.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_posterior = 0.02;  // of a rival worth a drive
constexpr std::size_t max_rivals = 3;
constexpr double min_nats = 3.0;  // a drive that tells less apart is not worth its time
const std::string nothing = "nothing";

// One manoeuvre with what it would tell.
struct ManoeuvreOption {
  std::string name;
  DriveLog commands;
  std::vector<std::string> makes_testable;
  // Of the pair that it separates the least; negative where it does not come into question.
  double nats = -1.0;
  std::array<std::string, 2> pair;
};

class Planner {
 public:
  Planner(const GapAnalysis& analysis, std::span<const DriveLog> train, const ManoeuvreLimits& limits,
          const ParallelFor& parallel_for);
  std::optional<NextExperiment> plan();

 private:
  std::vector<Hypothesis> rivals() const;
  Hypothesis hypothesis(const std::string& name, const TrialModel& model) const;
  TrialModel with_effect(const EffectInfo& info) const;
  std::vector<std::string> shown_by(const DriveLog& commands) const;
  void judge_rivals(ManoeuvreOption& candidate, const std::vector<Hypothesis>& rivals) const;
  void judge_untested(ManoeuvreOption& candidate) const;
  bool safe(const DriveLog& commands, const std::vector<Hypothesis>& rivals) const;

  const GapAnalysis& analysis_;
  std::span<const DriveLog> train_;
  ManoeuvreLimits limits_;
  const ParallelFor& parallel_for_;
  std::optional<FitProblem> problem_;
  std::vector<Untestable>
      untestable_;  // by the runs so far: they lack what it takes, or hold too little of it
  Sensors sensors_;
  Hypothesis present_;  // the model as it is
};

Planner::Planner(const GapAnalysis& analysis, std::span<const DriveLog> train, const ManoeuvreLimits& limits,
                 const ParallelFor& parallel_for)
    : analysis_(analysis),
      train_(train),
      limits_(limits),
      parallel_for_(parallel_for),
      untestable_(testability(train).untestable) {
  std::ranges::copy_if(analysis.not_testable, std::back_inserter(untestable_), [&](const Untestable& effect) {
    return std::ranges::find(untestable_, effect.effect, &Untestable::effect) == untestable_.end();
  });
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;
  for (const GatedLog& gated : gate_together(train)) {
    runs.push_back(make_gap_run(gated.log, gated.flags, shortest_period_s(train)));
    measure_motion(runs.back());
    metres_per_tick.push_back(gated.log.metres_per_tick.value_or(WheelPair{}));
  }
  sensors_ = sensors_of(runs.front());
  problem_.emplace(std::move(runs), std::move(metres_per_tick), parallel_for);
  TrialModel model = analysis.search.final.model;
  if (model.linear_part.empty()) {
    LinearPartShape shape;
    shape.shared = !sensors_.counts;
    model = first_guess(shape, shortest_period_s(train), train.front().wheel_base_m, 0.1, 0.036);
  } else {
    problem_->set_noise(problem_->noise_left_by(model));
  }
  present_ = hypothesis(nothing, model);
}

Hypothesis Planner::hypothesis(const std::string& name, const TrialModel& model) const {
  const Eigen::MatrixXd columns = problem_->jacobian(model, problem_->residuals(model));
  return {name, model, columns.transpose() * columns};
}

// The answers that are still possible in the place of the least certain finding.
std::vector<Hypothesis> Planner::rivals() const {
  const auto doubtful = std::ranges::min_element(analysis_.found, {}, &Finding::posterior);
  if (doubtful == analysis_.found.end() || doubtful->posterior >= sure_posterior) return {};
  const auto holds = [&](const TrialModel& model) {
    return std::ranges::any_of(model.effects, [&](const TrialEffect& effect) {
      return effect.info->name == doubtful->setting.name;
    });
  };
  const auto check = std::ranges::find_if(analysis_.search.checks, [&](const SelectionStep& selection_step) {
    return !holds(selection_step.without.model) &&
           std::ranges::any_of(selection_step.candidates, [&](const Candidate& one) {
             return one.effect.info->name == doubtful->setting.name;
           });
  });
  if (check == analysis_.search.checks.end()) return {};
  std::vector<Hypothesis> result;
  const auto add = [&](const std::string& name) {
    const auto best = std::ranges::find_if(check->candidates, [&](const Candidate& one) {
      return name == "decoy" ? is_decoy(*one.effect.info) : one.effect.info->name == name;
    });
    if (best != check->candidates.end()) result.push_back(hypothesis(name, best->fit.model));
  };
  add(doubtful->setting.name);
  for (const auto& rival : doubtful->rivals) {
    if (rival.posterior >= min_posterior && result.size() < 1 + max_rivals) add(rival.effect);
  }
  if (result.size() == 1) result.push_back(hypothesis(nothing, check->without.model));
  return result;
}

// An effect at a size in the middle of those that a search begins from.
TrialModel Planner::with_effect(const EffectInfo& info) const {
  TrialEffect effect{&info, 0, {}};
  for (const auto& parameter : info.parameters_of(effect.variant)) {
    effect.parameters.push_back(parameter.sizes.empty() ? 0.5 * (parameter.lower + parameter.upper)
                                                        : parameter.sizes[parameter.sizes.size() / 2]);
  }
  TrialModel model = present_.model;
  model.effects.push_back(std::move(effect));
  return model;
}

// Untestable effects that the runs so far and this drive together would show.
std::vector<std::string> Planner::shown_by(const DriveLog& commands) const {
  std::vector<DriveLog> logs(train_.begin(), train_.end());
  logs.push_back(driven_by(present_.model, commands, sensors_));
  const Testability with = testability(logs);
  std::vector<std::string> names;
  for (const auto& effect : untestable_) {
    const bool shown = std::ranges::any_of(
        with.candidate_effects, [&](const EffectInfo* info) { return info->name == effect.effect; });
    if (shown) names.push_back(effect.effect);
  }
  return names;
}

bool Planner::safe(const DriveLog& commands, const std::vector<Hypothesis>& rivals) const {
  return stays_inside(present_.model, commands, limits_.radius_m) &&
         std::ranges::all_of(rivals, [&](const Hypothesis& rival) {
           return stays_inside(rival.model, commands, limits_.radius_m);
         });
}

void Planner::judge_rivals(ManoeuvreOption& candidate, const std::vector<Hypothesis>& rivals) const {
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      // Any effect can be as small as nothing, so a drive by nothing tells nothing apart.
      const double one = divergence(rivals[j], rivals[i], candidate.commands, sensors_, problem_->noise());
      const double nats = rivals[i].name == nothing
                              ? one
                              : std::min(one, divergence(rivals[i], rivals[j], candidate.commands, sensors_,
                                                         problem_->noise()));
      if (candidate.nats >= 0.0 && nats >= candidate.nats) continue;
      candidate.nats = nats;
      candidate.pair = {rivals[j].name, rivals[i].name};
    }
  }
}

// Effects that would still not show are no merit of the drive.
void Planner::judge_untested(ManoeuvreOption& candidate) const {
  std::vector<std::string> shown;
  for (const auto& name : candidate.makes_testable) {
    const EffectInfo* info = find_effect(name);
    if (info == nullptr) continue;
    const Hypothesis effect{name, with_effect(*info), {}};
    const double nats = divergence(effect, present_, candidate.commands, sensors_, problem_->noise());
    if (nats < min_nats) continue;
    shown.push_back(name);
    if (candidate.nats >= 0.0 && nats >= candidate.nats) continue;
    candidate.nats = nats;
    candidate.pair = {name, nothing};
  }
  candidate.makes_testable = std::move(shown);
}

std::optional<NextExperiment> Planner::plan() {
  const std::vector<Hypothesis> possible = rivals();
  const auto menu = safe_manoeuvres(limits_, present_.model.wheel_base_m, present_.model.period_s);
  std::vector<ManoeuvreOption> candidate_effects(menu.size());
  parallel_for_(menu.size(), [&](std::size_t m) {
    ManoeuvreOption& candidate = candidate_effects[m];
    candidate.name = menu[m].name;
    candidate.commands = commands_of(menu[m], present_.model);
    if (!safe(candidate.commands, possible)) return;
    candidate.makes_testable = shown_by(candidate.commands);
    if (possible.empty()) {
      judge_untested(candidate);
    } else {
      judge_rivals(candidate, possible);
    }
  });
  const auto best = std::ranges::max_element(candidate_effects, {}, [&](const ManoeuvreOption& candidate) {
    return std::pair(possible.empty() ? candidate.makes_testable.size() : 0, candidate.nats);
  });
  if (best == candidate_effects.end() || best->nats < min_nats) return std::nullopt;
  return NextExperiment{best->name,
                        best->commands,
                        best->pair,
                        best->nats,
                        best->commands.period_s * static_cast<double>(best->commands.samples.size()),
                        best->makes_testable};
}

}  // namespace

ManoeuvreLimits limits_of(std::span<const DriveLog> logs) {
  constexpr double never_driven_m_s = 0.2;
  constexpr double min_m_s = 0.1;
  ManoeuvreLimits limits;
  double largest = 0.0;
  for (const auto& log : logs) {
    WheelPair before = log.samples.empty() ? WheelPair{} : log.samples.front().command_m_s;
    for (const auto& sample : log.samples) {
      const WheelPair& u = sample.command_m_s;
      largest = std::max({largest, std::abs(u.left), std::abs(u.right)});
      limits.largest_change_m_s = std::max(
          {limits.largest_change_m_s, std::abs(u.left - before.left), std::abs(u.right - before.right)});
      before = u;
    }
  }
  limits.largest_speed_m_s =
      largest < min_m_s ? never_driven_m_s : std::min(limits.largest_speed_m_s, largest);
  return limits;
}

std::optional<NextExperiment> next_experiment(const GapAnalysis& analysis, std::span<const DriveLog> train,
                                              const ManoeuvreLimits& limits,
                                              const ParallelFor& parallel_for) {
  const bool faulty = analysis.verdict == Verdict::bad_data;
  const bool doubt = analysis.verdict == Verdict::ambiguous || !analysis.not_testable.empty();
  if (faulty || !doubt || train.empty()) return std::nullopt;
  return Planner(analysis, train, limits, parallel_for).plan();
}

}  // namespace wheelwright::gap
