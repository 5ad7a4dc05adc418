#include "model/gap/conclusion/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/conclusion/acceptance.hpp"
#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/gap/runs/short_name.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double worth_saying = 0.005;  // relative, of a gain or a scale

std::string in_words(const Excess& excess) {
  const auto tenths = std::lround(10.0 * excess.times);
  return std::string(excess.figure) + " is off " + std::to_string(tenths / 10) + "." +
         std::to_string(tenths % 10) + " times as far as by noise alone";
}

struct Judgement {
  Verdict verdict;
  std::string summary;
  std::vector<Regime> where = {};
};

Judgement of_findings(const std::vector<Finding>& found) {
  const auto doubtful =
      std::ranges::find_if(found, [](const Finding& one) { return one.posterior < sure_posterior; });
  if (doubtful != found.end()) {
    return {Verdict::ambiguous,
            "Something is missing, but these runs do not distinguish " + doubtful->setting.name + " from " +
                (doubtful->rivals.empty() ? std::string("others") : doubtful->rivals.front().effect) + "."};
  }
  Judgement named{Verdict::named, "Missing:"};
  for (const auto& one : found) named.summary += " " + one.setting.name;
  named.summary += ".";
  return named;
}

// Whether the best of the last round would have been accepted, had it a name.
bool decoy_explains(const GapAnalysis& analysis, const SearchLimits& limits) {
  const auto& last = analysis.search.selection_steps.back().candidates;
  if (last.empty() || !is_decoy(*last.front().effect.info)) return false;
  const double train_nats = last.front().deflated_train_nats();
  const double heldout_nats = last.front().deflated_unseen_nats();
  if (heldout_nats > beyond_doubt_nats && train_nats > beyond_doubt_nats) return true;
  return heldout_nats > limits.min_heldout_nats && train_nats > limits.min_train_nats &&
         some_figure_above_noise(analysis.tail_held_out ? analysis.train : analysis.test);
}

// As in "run3 by 97 per mille", or with each wheel's own where they differ.
std::string in_words(std::span<const GainChange> changes) {
  constexpr double as_good_as_one = 0.01;
  const auto per_mille = [](double gain) { return std::to_string(std::lround(1000.0 * (gain - 1.0))); };
  std::string words;
  for (const auto& [run, gain] : changes) {
    const bool as_one = std::abs(gain.left - gain.right) < as_good_as_one;
    words += (words.empty() ? "" : ", ") + run + " by " +
             (as_one ? per_mille(0.5 * (gain.left + gain.right)) + " per mille"
                     : per_mille(gain.left) + " per mille left and " + per_mille(gain.right) + " right");
  }
  return words;
}

// By the noise from reading to reading and by that over seconds; far above the first, the second may have
// taken up what is missing.
bool more_than_any_noise(const Excess& over_quick_noise, const Excess& over_slow_noise) {
  constexpr double beyond_slow_noise = 3.0;
  return std::min(over_quick_noise.times, over_slow_noise.times) >= more_than_noise ||
         over_quick_noise.times >= beyond_slow_noise;
}

// A tail that was held out of the only run is the same drive's.
std::optional<Excess> only_held_out(const GapAnalysis& analysis) {
  if (analysis.tail_held_out) return std::nullopt;
  return held_out_alone(analysis.train, analysis.test);
}

Judgement of_nothing_found(const GapAnalysis& analysis, const SearchLimits& limits,
                           const ResidualDiagnostics& residual) {
  const Excess& over_quick_noise = residual.over_quick_noise;
  const auto& changes = residual.gain_changes;
  if (decoy_explains(analysis, limits)) {
    const EffectInfo& decoy = *analysis.search.selection_steps.back().candidates.front().effect.info;
    return {Verdict::unnamed, "Something is missing that no effect of the library explains: it is as if " +
                                  decoy.summary + "."};
  }
  if (!changes.empty()) {
    Judgement changed{Verdict::unnamed, "The gain changed between training and held-out runs (" +
                                            in_words(changes) + "); these logs cannot say why."};
    const double share = 1.0 / static_cast<double>(analysis.test_runs);
    for (const auto& change : changes) changed.where.push_back({"run " + change.run, share, share});
    return changed;
  }
  if (std::ranges::count_if(analysis.data_faults, &DataFault::happened) >=
      static_cast<std::ptrdiff_t>(more_than_chance)) {
    return {
        Verdict::unnamed,
        "Something held a wheel several times, which no effect of the library does; the moments are listed."};
  }
  if (std::ranges::any_of(analysis.data_faults, &DataFault::distorts)) {
    return {Verdict::bad_data,
            "Faults of the data explain the gap; without those rows nothing is missing that could show."};
  }
  // That no effect was found does not mean that nothing is missing: where the free runs are off by more than
  // noise explains, in the runs that were fitted and in those that were not, something is.
  if (more_than_any_noise(over_quick_noise, residual_excess(analysis))) {
    return {Verdict::unnamed, "Something is missing that no effect of the library explains: in free runs " +
                                  in_words(over_quick_noise) + "."};
  }
  if (const auto excess = only_held_out(analysis)) {
    return {Verdict::unnamed, "Something changed between training and held-out runs: in these, " +
                                  in_words(*excess) + "; these logs cannot say why."};
  }
  return {Verdict::nothing_missing, "Nothing is missing that these runs could show."};
}

// What a linear part without counts came to for each wheel when both are told the same, and for turns beside
// driving.
std::string gains_in_words(const TrialModel& model) {
  if (model.linear_part.empty()) return {};
  const LinearModel linear_part = model.linear();
  const DcGain left = dc_gain(linear_part.left);
  const DcGain right = dc_gain(linear_part.right);
  const double drives = left.from_left + left.from_right + right.from_right + right.from_left;
  const double turns = left.from_left - left.from_right + right.from_right - right.from_left;
  const double excess =
      2.0 * (right.from_right + right.from_left - left.from_left - left.from_right) / drives;
  const double turns_more = turns / drives - 1.0;
  const auto in_percent = [](double share) {
    return in_digits(100.0 * std::abs(share), 2) + " % " + (share < 0.0 ? "less" : "more");
  };
  std::string words;
  if (std::abs(excess) > worth_saying)
    words = " The right wheel rolls " + in_percent(excess) + " than the left";
  if (std::abs(turns_more) > worth_saying) {
    words += (words.empty() ? " The robot turns " : ", and the robot turns ") + in_percent(turns_more) +
             " than it drives";
  }
  if (!words.empty())
    words += " by the same commands; these logs do not show why, and the linear part contains it.";
  return words;
}

// Beyond what gyros err, relative: the wheel base is not what it was said to be, or the gyro's unit.
constexpr double min_reported_gyro_scale = 0.05;

std::string gyro_scale_in_words(double scale) {
  return std::string("The gyro shows ") + (std::abs(scale) < largest_gyro_scale ? "" : "at least ") +
         in_digits(100.0 * std::abs(scale), 2) + " % " + (scale > 0.0 ? "more" : "less") +
         " turn than the counts: the wheel base or the gyro's scale is off, and only turns against "
         "an outside mark show which.";
}

// What was found holds for a run whose wheels begin at a known angle: that has to be said.
bool wheels_began_apart(const GapSearch& search) {
  const bool rippling = std::ranges::any_of(
      search.final.model.effects, [](const TrialEffect& effect) { return effect.info->by_wheel_angle; });
  const auto apart = [](const WheelPair& way) { return way.left != 0.0 || way.right != 0.0; };
  return rippling && std::ranges::any_of(search.train_rolled_m, apart);
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

std::vector<GainChange> changed_gains(const GapAnalysis& analysis, const FitProblem& train,
                                      const FitProblem& heldout) {
  constexpr double much_worse = 1.5;  // mean square of held-out residuals against those of training
  constexpr double min_change = 0.01;
  constexpr double beyond_usual = 2.0;
  const GapSearch& search = analysis.search;
  const double fitted = search.final.sum_squares / static_cast<double>(train.readings());
  const double held_out = search.heldout_sum_squares_after / static_cast<double>(heldout.readings());
  std::vector<GainChange> changes;
  if (held_out < much_worse * fitted && !only_held_out(analysis)) return changes;
  // By as much as that of a run that the model was fitted to, no gain has changed.
  const auto change_of = [](const WheelPair& gain) {
    return std::max(std::abs(gain.left - 1.0), std::abs(gain.right - 1.0));
  };
  double usual = 0.0;
  for (const GapRun& run : train.runs())
    usual = std::max(usual, change_of(travel_gain(search.final.model, run)));
  for (std::size_t r = 0; r < heldout.runs().size(); ++r) {
    const GapRun& run = heldout.runs()[r];
    const WheelPair gain = travel_gain(search.final.model, run);
    if (change_of(gain) >= std::max(min_change, beyond_usual * usual))
      changes.push_back({short_name(r, heldout.runs()), gain});
  }
  return changes;
}

bool data_decide(GapAnalysis& analysis, const RunSet& train, const Testability& testability) {
  const bool faulty = std::ranges::any_of(analysis.data_faults, &DataFault::explains);
  if (faulty) {
    analysis.verdict = Verdict::bad_data;
    analysis.summary = "The data contradict themselves: " +
                       std::ranges::find_if(analysis.data_faults, &DataFault::explains)->what + ".";
    return true;
  }
  double largest = 0.0;
  for (const auto& run : train.runs) {
    for (const auto& u : run.commands_m_s) largest = std::max({largest, std::abs(u.left), std::abs(u.right)});
  }
  const bool seen = std::ranges::any_of(train.runs, [](const GapRun& run) {
    return run.has_counts || (run.references.size() > 50 && !run.sparse && !run.heading_alone);
  });
  if (largest > 0.005 && seen) return false;
  analysis.verdict = Verdict::not_testable;
  analysis.summary =
      largest > 0.005
          ? "The logs hold no encoder counts, and no reference poses often enough to show how the wheels "
            "answer; record counts, or a pose at least once a second."
          : "The robot was never commanded to move in these runs.";
  for (const EffectInfo* info : testability.candidate_effects) {
    if (is_decoy(*info)) continue;
    analysis.not_testable.push_back({info->name, largest > 0.005
                                                     ? "no encoder counts and too few reference poses"
                                                     : "the robot was never commanded to move"});
  }
  return true;
}

void reach_verdict(GapAnalysis& analysis, const SearchLimits& limits, const ResidualDiagnostics& residual) {
  Judgement judgement =
      analysis.found.empty() ? of_nothing_found(analysis, limits, residual) : of_findings(analysis.found);
  analysis.verdict = judgement.verdict;
  analysis.summary = std::move(judgement.summary);
  analysis.where = std::move(judgement.where);
  if (wheels_began_apart(analysis.search)) {
    analysis.summary +=
        " The wheels began each run at another angle; the figures take the angles that each run showed.";
  }
  const double gyro_scale = analysis.search.final.model.gyro_scale();
  if (analysis.verdict == Verdict::nothing_missing && std::abs(gyro_scale) > min_reported_gyro_scale) {
    analysis.verdict = Verdict::unnamed;
    analysis.summary = gyro_scale_in_words(gyro_scale);
  } else if (std::abs(gyro_scale) > worth_saying) {
    analysis.summary += " " + gyro_scale_in_words(gyro_scale);
  }
  if (!residual.counted) analysis.summary += gains_in_words(analysis.search.final.model);
  const Excess left = residual_excess(analysis);
  if (analysis.verdict == Verdict::named && left.times >= far_above_noise) {
    analysis.summary += " More may be: in free runs " + in_words(left) + ".";
  }
}

}  // namespace wheelwright::gap
