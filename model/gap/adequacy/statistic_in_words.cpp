#include "model/gap/adequacy/statistic_in_words.hpp"

#include <algorithm>
#include <iomanip>
#include <span>
#include <sstream>
#include <string>

#include "model/gap/runs/short_name.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

std::string size_in_words(double size, bool angle) {
  return in_digits(1000.0 * size, 2) + (angle ? " mrad" : " mm");
}

bool is_visible(double size, Channel channel) {
  return size >= visible_size(channel);
}

// In milli-units.
std::vector<std::pair<double, double>> in_milli(std::vector<std::pair<double, double>> points) {
  for (auto& [x, y] : points) y *= 1000.0;
  return points;
}

}  // namespace

double visible_size(Channel channel) {
  if (channel == Channel::turn) return visible_heading_rad;
  const bool of_wheel = channel == Channel::left || channel == Channel::right;
  return of_wheel ? visible_travel_m : visible_position_m;
}

CheckStatistic statistic_of(const ChannelWords& of, const PeriodicResidual& found, double heading_swing_rad) {
  const bool over_time = found.over == PeriodicResidual::Over::time;
  CheckStatistic statistic;
  statistic.name =
      std::string("periodic residual") + (over_time ? "" : " over travel") + ", " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.amplitude;
  statistic.visible = is_visible(2.0 * found.amplitude, of.channel);  // from crest to trough
  const std::string every =
      over_time ? in_digits(found.period, 3) + " s" : in_digits(1000.0 * found.period, 3) + " mm of travel";
  statistic.sentence = "the error of the " + std::string(of.name) + " swings every " + every + " by " +
                       size_in_words(found.amplitude, of.angle) + " to either side";
  statistic.regime = "a swing every " + every;
  statistic.curve = {over_time ? "time within a period, where it swings most [s]"
                               : "travel within a period, where it swings most [m]",
                     "error of the " + std::string(of.name) + (of.angle ? " [mrad]" : " [mm]"),
                     in_milli(found.folded)};
  statistic.share_of_gap = found.share;
  statistic.detail = {{over_time ? "period_s" : "period_m", found.period},
                      {of.angle ? "amplitude_rad" : "amplitude_m", found.amplitude}};
  if (!statistic.visible && is_visible(2.0 * heading_swing_rad, Channel::turn)) {
    statistic.visible = true;
    statistic.sentence = "the heading, by the wheels, swings every " + every + " by " +
                         size_in_words(heading_swing_rad, true) + " to either side";
    statistic.detail.emplace_back("heading_amplitude_rad", heading_swing_rad);
  }
  return statistic;
}

CheckStatistic statistic_of(const ChannelWords& of, const Covariate& covariate, const Dependence& found) {
  CheckStatistic statistic;
  std::string quantity(covariate.name);
  if (quantity.starts_with("the ")) quantity.erase(0, 4);
  statistic.name = "dependence on " + quantity + ", " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.size;
  statistic.visible = is_visible(found.size, of.channel);
  statistic.regime = quantity + " from " + in_digits(found.from, 2) + " to " + in_digits(found.to, 2) + " " +
                     std::string(covariate.unit);
  statistic.sentence = "the error of the " + std::string(of.name) + " depends on " +
                       std::string(covariate.name) + " (" + size_in_words(found.size, of.angle) +
                       " in 10 s, most with " + statistic.regime + ")";
  statistic.share_of_time = found.share_of_time;
  statistic.curve = {quantity + " [" + std::string(covariate.unit) + "]",
                     "drift of the " + std::string(of.name) + (of.angle ? " [mrad/s]" : " [mm/s]"),
                     in_milli(found.rates)};
  statistic.share_of_gap = found.share;
  statistic.detail = {{"from", found.from}, {"to", found.to}, {of.angle ? "size_rad" : "size_m", found.size}};
  return statistic;
}

CheckStatistic statistic_of(const ChannelWords& of, const OffsetOverHeading& found) {
  CheckStatistic statistic;
  statistic.name = "offset over heading, " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.size;
  statistic.visible = is_visible(found.size, of.channel);
  const std::string often = found.harmonic == 1 ? "once" : "twice";
  statistic.sentence = "the measured " + std::string(of.name) + " is off by " +
                       size_in_words(found.size, of.angle) + ", " + often +
                       " to and fro in a turn of the robot";
  statistic.regime = "an offset that swings " + often + " in a turn of the robot";
  statistic.curve = {"heading [rad]",
                     "offset of the " + std::string(of.name) + (of.angle ? " [mrad]" : " [mm]"),
                     in_milli(found.curve)};
  statistic.detail = {{"swings_per_turn", static_cast<double>(found.harmonic)},
                      {of.angle ? "amplitude_rad" : "amplitude_m", found.size}};
  return statistic;
}

CheckStatistic statistic_of(const ChannelWords& of, const FitProblem& problem,
                            const IntermittentEvents& found) {
  constexpr std::size_t named_events = 3;
  std::ostringstream events;
  events << std::fixed << std::setprecision(1);
  for (const auto& event : std::span(found.events).first(std::min(named_events, found.events.size()))) {
    events << (events.view().empty() ? "" : ", ") << short_name(event.run, problem.runs()) << " at "
           << problem.runs()[event.run].start_s + event.time_s << " s";
  }
  CheckStatistic statistic;
  statistic.name = "intermittent events, " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.size;
  statistic.visible = is_visible(found.size, of.channel);
  statistic.predictable = false;
  statistic.curve = {"time in " + short_name(found.events.front().run, problem.runs()) + " [s]",
                     "change of the error in 0.3 s" + std::string(of.angle ? " [mrad]" : " [mm]"),
                     in_milli(found.changes)};
  statistic.regime = "events like " + events.str();
  statistic.sentence = "something happens to the " + std::string(of.name) +
                       " now and then: " + in_digits(100.0 * found.share_of_time, 2) +
                       " % of the time holds " + in_digits(100.0 * found.share, 2) +
                       " % of the residual power (" + events.str() + ")";
  statistic.share_of_gap = found.share;
  statistic.share_of_time = found.share_of_time;
  statistic.detail = {{"events", static_cast<double>(found.events.size())},
                      {of.angle ? "size_rad" : "size_m", found.size}};
  return statistic;
}

CheckStatistic statistic_of(const ChannelWords& of, const ReversalResidual& found) {
  CheckStatistic statistic;
  statistic.name = "residual after reversals, " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.size;
  statistic.visible = is_visible(found.size, of.channel);
  statistic.regime = "within 0.7 s of a reversal";
  statistic.curve = {"time since a reversal [s]", "mean squared innovation", found.power};
  statistic.sentence = "where the " + std::string(of.name) + " changes direction, the residual variance is " +
                       in_digits(found.ratio, 2) + " times that elsewhere";
  statistic.share_of_gap = found.share;
  statistic.share_of_time = found.share_of_time;
  statistic.detail = {{"ratio", found.ratio}, {"size_m", found.size}};
  return statistic;
}

CheckStatistic statistic_of(const ChannelWords& of, const Drift& found) {
  CheckStatistic statistic;
  statistic.name = "drift, " + std::string(of.name);
  statistic.p_value = found.p_value;
  statistic.size = found.size;
  statistic.visible = is_visible(found.size, of.channel);
  statistic.predictable = false;
  statistic.regime = "everywhere";
  statistic.sentence = "the " + std::string(of.name) + " drifts by " +
                       size_in_words(found.rate_per_sqrt_s, of.angle) +
                       " within a second, further than sound robots do";
  statistic.share_of_gap = 1.0;
  statistic.detail = {{of.angle ? "rate_rad_per_sqrt_s" : "rate_m_per_sqrt_s", found.rate_per_sqrt_s}};
  return statistic;
}

}  // namespace wheelwright::gap
