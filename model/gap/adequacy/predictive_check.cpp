#include "model/gap/adequacy/predictive_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "model/gap/adequacy/covariates.hpp"
#include "model/gap/adequacy/dependence.hpp"
#include "model/gap/adequacy/offset_over_heading.hpp"
#include "model/gap/adequacy/periodic_residual.hpp"
#include "model/gap/adequacy/tail_probability.hpp"

namespace wheelwright::gap {
namespace {

using Tracks = std::vector<const ResidualTrack*>;

struct ChannelWords {
  Channel channel;
  std::string_view name;
  bool angle;
};
constexpr std::array<ChannelWords, channel_count> channels{{{Channel::left, "left wheel", false},
                                                            {Channel::right, "right wheel", false},
                                                            {Channel::forward, "forward motion", false},
                                                            {Channel::aside, "sideways motion", false},
                                                            {Channel::turn, "heading", true}}};

std::string in_words(double value, int digits = 3) {
  std::ostringstream words;
  words << std::setprecision(digits) << value;
  return words.str();
}

std::string size_in_words(double size, bool angle) {
  return in_words(1000.0 * size, 2) + (angle ? " mrad" : " mm");
}

bool is_visible(double size, Channel channel) {
  if (channel == Channel::turn) return size >= visible_heading_rad;
  const bool of_wheel = channel == Channel::left || channel == Channel::right;
  return size >= (of_wheel ? visible_travel_m : visible_position_m);
}

// In milli-units.
std::vector<std::pair<double, double>> in_milli(std::vector<std::pair<double, double>> points) {
  for (auto& [x, y] : points) y *= 1000.0;
  return points;
}

std::vector<std::vector<double>> times_of(const Tracks& tracks) {
  std::vector<std::vector<double>> at;
  for (const ResidualTrack* track : tracks) at.push_back(track->time_s);
  return at;
}

std::vector<std::vector<double>> travel_of(const GapProblem& problem, const Tracks& tracks) {
  std::vector<std::vector<double>> at;
  for (const ResidualTrack* track : tracks) at.push_back(problem.runs()[track->run][track->channel].value);
  return at;
}

void add(std::vector<CheckStatistic>& all, const ChannelWords& of,
         const std::optional<PeriodicResidual>& found) {
  if (!found) return;
  const bool over_time = found->over == PeriodicResidual::Over::time;
  CheckStatistic statistic;
  statistic.name =
      std::string("periodic residual") + (over_time ? "" : " over travel") + ", " + std::string(of.name);
  statistic.p_value = found->p_value;
  statistic.size = found->amplitude;
  statistic.visible = is_visible(found->amplitude, of.channel);
  const std::string every =
      over_time ? in_words(found->period) + " s" : in_words(1000.0 * found->period) + " mm of travel";
  statistic.sentence = "the error of the " + std::string(of.name) + " swings every " + every + " by " +
                       size_in_words(found->amplitude, of.angle);
  statistic.regime = "a swing every " + every;
  statistic.curve = {over_time ? "time within a period [s]" : "travel within a period [m]",
                     "error of the " + std::string(of.name) + (of.angle ? " [mrad]" : " [mm]"),
                     in_milli(found->folded)};
  statistic.share_of_gap = found->share;
  statistic.detail = {{over_time ? "period_s" : "period_m", found->period},
                      {of.angle ? "amplitude_rad" : "amplitude_m", found->amplitude}};
  all.push_back(std::move(statistic));
}

void add(std::vector<CheckStatistic>& all, const ChannelWords& of, const Covariate& covariate,
         const std::optional<Dependence>& found) {
  if (!found) return;
  CheckStatistic statistic;
  std::string quantity(covariate.name);
  if (quantity.starts_with("the ")) quantity.erase(0, 4);
  statistic.name = "dependence on " + quantity + ", " + std::string(of.name);
  statistic.p_value = found->p_value;
  statistic.size = found->size;
  statistic.visible = is_visible(found->size, of.channel);
  statistic.regime = quantity + " from " + in_words(found->from, 2) + " to " + in_words(found->to, 2) + " " +
                     std::string(covariate.unit);
  statistic.sentence = "the error of the " + std::string(of.name) + " depends on " +
                       std::string(covariate.name) + " (" + size_in_words(found->size, of.angle) +
                       " in 10 s, most with " + statistic.regime + ")";
  statistic.share_of_time = found->share_of_time;
  statistic.curve = {quantity + " [" + std::string(covariate.unit) + "]",
                     "drift of the " + std::string(of.name) + (of.angle ? " [mrad/s]" : " [mm/s]"),
                     in_milli(found->rates)};
  statistic.share_of_gap = found->share;
  statistic.detail = {
      {"from", found->from}, {"to", found->to}, {of.angle ? "size_rad" : "size_m", found->size}};
  all.push_back(std::move(statistic));
}

void add(std::vector<CheckStatistic>& all, const ChannelWords& of,
         const std::optional<OffsetOverHeading>& found) {
  if (!found) return;
  CheckStatistic statistic;
  statistic.name = "offset over heading, " + std::string(of.name);
  statistic.p_value = found->p_value;
  statistic.size = found->size;
  statistic.visible = is_visible(found->size, of.channel);
  const std::string often = found->harmonic == 1 ? "once" : "twice";
  statistic.sentence = "the measured " + std::string(of.name) + " is off by " +
                       size_in_words(found->size, of.angle) + ", " + often +
                       " to and fro in a turn of the robot";
  statistic.regime = "an offset that swings " + often + " in a turn of the robot";
  statistic.curve = {"heading [rad]",
                     "offset of the " + std::string(of.name) + (of.angle ? " [mrad]" : " [mm]"),
                     in_milli(found->curve)};
  statistic.detail = {{"swings_per_turn", static_cast<double>(found->harmonic)},
                      {of.angle ? "amplitude_rad" : "amplitude_m", found->size}};
  all.push_back(std::move(statistic));
}

}  // namespace

PredictiveCheck predictive_check(const GapProblem& problem, const TrialModel& model) {
  const auto tracks = residual_tracks(problem, model);
  const auto poses = predicted_poses(problem, model);
  PredictiveCheck check;
  for (const ChannelWords& of : channels) {
    Tracks of_channel;
    for (const ResidualTrack& track : tracks) {
      if (track.channel == of.channel) of_channel.push_back(&track);
    }
    if (of_channel.empty()) continue;
    add(check.statistics, of,
        periodic_residual(of_channel, times_of(of_channel), PeriodicResidual::Over::time));
    if (of_channel.front()->of_wheel()) {
      add(check.statistics, of,
          periodic_residual(of_channel, travel_of(problem, of_channel), PeriodicResidual::Over::travel));
    }
    for (const Covariate& covariate : covariates_for(problem, poses, of_channel)) {
      add(check.statistics, of, covariate, dependence(of_channel, covariate));
      const bool is_heading = covariate.name == heading_name;
      if (is_heading && !of_channel.front()->of_wheel())
        add(check.statistics, of, offset_over_heading(problem, of_channel, covariate.value));
    }
  }
  std::ranges::sort(check.statistics, [](const CheckStatistic& one, const CheckStatistic& other) {
    if (one.visible != other.visible) return one.visible;
    return std::pair(one.p_value, -one.size) < std::pair(other.p_value, -other.size);
  });
  if (!check.statistics.empty() && check.statistics.front().visible) {
    check.p_value =
        smallest_of(check.statistics.front().p_value, static_cast<double>(check.statistics.size()));
  }
  check.passed = check.p_value >= check_level;
  return check;
}

}  // namespace wheelwright::gap
