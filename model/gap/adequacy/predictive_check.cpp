#include "model/gap/adequacy/predictive_check.hpp"

#include <algorithm>
#include <array>
#include <tuple>

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

std::vector<CheckStatistic> statistics_of(const ChannelWords& of, const FitProblem& problem,
                                          const Tracks& tracks, std::span<const std::vector<Pose>> poses) {
  std::vector<CheckStatistic> all;
  const bool of_wheel = tracks.front()->of_wheel();
  if (const auto found = periodic_residual(tracks, times_of(tracks), PeriodicResidual::Over::time))
    all.push_back(statistic_of(of, *found));
  if (of_wheel) {
    if (const auto found =
            periodic_residual(tracks, travel_of(problem, tracks), PeriodicResidual::Over::travel))
      all.push_back(statistic_of(of, *found));
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
  for (const ChannelWords& of : channels) {
    Tracks of_channel;
    for (const ResidualTrack& track : tracks) {
      if (track.channel == of.channel) of_channel.push_back(&track);
    }
    if (of_channel.empty()) continue;
    std::ranges::move(statistics_of(of, problem, of_channel, poses), std::back_inserter(check.statistics));
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
