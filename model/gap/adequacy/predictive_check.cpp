#include "model/gap/adequacy/predictive_check.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "model/gap/adequacy/heading_swing.hpp"
#include "model/gap/adequacy/statistic_in_words.hpp"
#include "model/gap/adequacy/tail_probability.hpp"

namespace wheelwright::gap {
namespace {

using Tracks = std::vector<const ResidualTrack*>;

constexpr std::array<ChannelWords, channel_count> channels{{{Channel::left, "left wheel", false},
                                                            {Channel::right, "right wheel", false},
                                                            {Channel::forward, "forward motion", false},
                                                            {Channel::aside, "sideways motion", false},
                                                            {Channel::turn, "heading", true}}};

// Of sound robots, simulated and real ones.
constexpr DriftPrior drift_of_travel{0.002, 0.55};
constexpr DriftPrior drift_of_heading{0.003, 0.55};

std::vector<std::vector<double>> times_of(const Tracks& tracks) {
  std::vector<std::vector<double>> at;
  for (const ResidualTrack* track : tracks) at.push_back(track->time_s);
  return at;
}

std::vector<std::vector<double>> travel_of(const FitProblem& problem, const Tracks& tracks) {
  std::vector<std::vector<double>> at;
  for (const ResidualTrack* track : tracks) at.push_back(problem.runs()[track->run][track->channel].value);
  return at;
}

// A swing of a wheel, from crest to trough, of no more than a count: at a steady speed its rounding repeats.
bool is_rounding(const FitProblem& problem, const Tracks& tracks, const PeriodicResidual& found) {
  return std::ranges::any_of(tracks, [&](const ResidualTrack* track) {
    const WheelPair& tick_m = problem.metres_per_tick(track->run);
    return 2.0 * found.amplitude <= (track->channel == Channel::left ? tick_m.left : tick_m.right);
  });
}

// The residuals of one channel, those of all in `by_channel`.
std::vector<CheckStatistic> statistics_of(const ChannelWords& of, const FitProblem& problem,
                                          const std::array<Tracks, channel_count>& by_channel,
                                          std::span<const std::vector<Pose>> poses) {
  std::vector<CheckStatistic> all;
  const auto tracks_of = [&](Channel channel) -> const Tracks& {
    return by_channel.at(static_cast<std::size_t>(channel));
  };
  const Tracks& tracks = tracks_of(of.channel);
  const bool of_wheel = tracks.front()->of_wheel();
  const auto add_periodic = [&](const std::vector<std::vector<double>>& at, PeriodicResidual::Over over) {
    const auto found = periodic_residual(tracks, at, over);
    if (!found) return;
    const double heading_rad =
        of_wheel ? heading_swing_rad(problem, *found, tracks_of(Channel::left), tracks_of(Channel::right), at)
                 : 0.0;
    if (of_wheel && heading_rad == 0.0 && is_rounding(problem, tracks, *found)) return;
    all.push_back(statistic_of(of, *found, heading_rad));
  };
  add_periodic(times_of(tracks), PeriodicResidual::Over::time);
  if (of_wheel) {
    add_periodic(travel_of(problem, tracks), PeriodicResidual::Over::travel);
    if (const auto found = reversal_residual(problem, tracks)) all.push_back(statistic_of(of, *found));
  }
  for (const Covariate& covariate : covariates_for(problem, poses, tracks)) {
    if (const auto found = dependence(tracks, covariate)) all.push_back(statistic_of(of, covariate, *found));
    if (of_wheel || covariate.name != heading_name) continue;
    if (const auto found = offset_over_heading(problem, tracks, covariate.value))
      all.push_back(statistic_of(of, *found));
  }
  if (const auto found =
          intermittent_events(tracks, recent_commands(problem, tracks), visible_size(of.channel)))
    all.push_back(statistic_of(of, problem, *found));
  if (const auto found = drift(tracks, of.angle ? drift_of_heading : drift_of_travel))
    all.push_back(statistic_of(of, *found));
  return all;
}

}  // namespace

PredictiveCheck predictive_check(const FitProblem& problem, const TrialModel& model) {
  const auto tracks = residual_tracks(problem, model);
  const auto poses = predicted_poses(problem, model);
  PredictiveCheck check;
  std::array<Tracks, channel_count> by_channel;
  for (const ResidualTrack& track : tracks)
    by_channel.at(static_cast<std::size_t>(track.channel)).push_back(&track);
  for (const ChannelWords& of : channels) {
    if (by_channel.at(static_cast<std::size_t>(of.channel)).empty()) continue;
    std::ranges::move(statistics_of(of, problem, by_channel, poses), std::back_inserter(check.statistics));
  }
  const auto corrected = [&](const CheckStatistic& statistic) {
    return smallest_of(statistic.p_value, static_cast<double>(check.statistics.size()));
  };
  const auto order = [&](const CheckStatistic& statistic) {
    const bool says_when = statistic.predictable && corrected(statistic) < check_level;
    return std::tuple(!statistic.visible, !says_when, statistic.p_value, -statistic.size);
  };
  std::ranges::sort(check.statistics, {}, order);
  for (const CheckStatistic& statistic : check.statistics) {
    if (statistic.visible) check.p_value = std::min(check.p_value, corrected(statistic));
  }
  check.passed = check.p_value >= check_level;
  return check;
}

}  // namespace wheelwright::gap
