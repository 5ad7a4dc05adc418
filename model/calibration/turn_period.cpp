#include "model/calibration/turn_period.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "model/calibration/turn_signal.hpp"

namespace wheelwright {
namespace {

constexpr double step_ticks = 4.0;           // about the ticks of one sample at calibration speed
constexpr double min_correlation = 0.6;      // a repetition worth the name
constexpr double min_signal_to_noise = 1.0;  // of the smoothed signal's power to the noise before smoothing

// A turn is more than this many ticks, whatever the robot.
constexpr double shortest_turn_ticks = 200.0;
constexpr std::size_t parts = 8;  // segments whose periods are compared

std::string rounded(double value, int decimals) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

struct Span {
  double from;
  double to;
};

// The lag of the best match within a span, refined between grid points by a parabola.
double best_lag(const TurnSignal& signal, Span lags, double step, std::size_t first, std::size_t last) {
  double best = lags.from;
  double best_match = -2.0;
  for (double lag = lags.from; lag <= lags.to; lag += step) {
    const double match = match_at_lag(signal, lag, first, last);
    if (match <= best_match) continue;
    best_match = match;
    best = lag;
  }
  const double before = match_at_lag(signal, best - step, first, last);
  const double after = match_at_lag(signal, best + step, first, last);
  const double bend = before - 2.0 * best_match + after;
  if (bend >= 0.0) return best;
  return best + std::clamp(0.5 * step * (before - after) / bend, -step, step);
}

// Every multiple of the period matches about as well as the period itself: the first of the good ones is
// wanted.
double first_good_lag(const TurnSignal& signal, Span lags) {
  constexpr double nearly_as_good = 0.95;
  const std::size_t all = signal.values.size();
  const double limit = nearly_as_good * match_at_lag(signal, best_lag(signal, lags, 1.0, 0, all), 0, all);
  for (double lag = lags.from + 1.0; lag < lags.to; lag += 1.0) {
    const double here = match_at_lag(signal, lag, 0, all);
    const bool peak =
        here >= match_at_lag(signal, lag - 1.0, 0, all) && here > match_at_lag(signal, lag + 1.0, 0, all);
    if (peak && here >= limit) return lag;
  }
  return lags.to;
}

double signal_to_noise(const TurnSignal& signal) {
  double power = 0.0;
  for (const auto& entry : signal.values) {
    for (std::size_t s = 0; s < TurnSignal::sensors; ++s)
      power += signal.weight.at(s) * entry.at(s) * entry.at(s);
  }
  return power / static_cast<double>(signal.values.size() * TurnSignal::sensors);
}

// The period as one segment of the turn shows it, and how much that segment has to say: the energy of its
// slope.
struct PartialPeriod {
  double period;
  double information;
};

double slope_energy(const TurnSignal& signal, std::size_t first, std::size_t last) {
  double energy = 0.0;
  for (std::size_t i = std::max<std::size_t>(first, 1); i + 1 < last; ++i) {
    for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
      const double slope = 0.5 * (signal.values[i + 1].at(s) - signal.values[i - 1].at(s));
      energy += signal.weight.at(s) * slope * slope;
    }
  }
  return energy;
}

// Each segment is matched with what comes one period later.
std::vector<PartialPeriod> periods_of_parts(const TurnSignal& signal, double period) {
  std::vector<PartialPeriod> result;
  const double usable = static_cast<double>(signal.values.size()) - 1.05 * period;
  const double length = usable / static_cast<double>(parts);
  for (std::size_t part = 0; part < parts; ++part) {
    const auto first = static_cast<std::size_t>(length * static_cast<double>(part));
    const auto last = static_cast<std::size_t>(length * static_cast<double>(part + 1));
    result.push_back({best_lag(signal, {0.97 * period, 1.03 * period}, 0.25, first, last),
                      slope_energy(signal, first, last)});
  }
  return result;
}

// Of the mean of the segments, weighed by what they have to say.
double relative_standard_error(const std::vector<PartialPeriod>& partial, double period) {
  double information = 0.0;
  double largest = 0.0;
  double spread = 0.0;
  for (const auto& part : partial) {
    information += part.information;
    largest = std::max(largest, part.information);
    spread += part.information * (part.period - period) * (part.period - period);
  }
  // One segment alone says nothing of its own error.
  const double effective = information / std::max(largest, 1e-300);
  if (effective < 1.5) return 1.0;
  return std::sqrt(spread / information / (effective - 1.0)) / period;
}

// A segment in which the summed signal stays high, but for the dips between two sensors' views: one pass of
// the obstacle, in entries of the signal.
struct Pass {
  std::size_t first;
  std::size_t last;
  double moment;
  double weight;
  double centre() const { return moment / weight; }
};

std::vector<Pass> find_passes(const TurnSignal& signal, double longest_dip) {
  std::vector<double> total(signal.values.size());
  for (std::size_t i = 0; i < total.size(); ++i) {
    for (const double value : signal.values[i]) total[i] += value;
  }
  const double threshold = 0.5 * *std::max_element(total.begin(), total.end());
  std::vector<Pass> passes;
  for (std::size_t i = 0; i < total.size(); ++i) {
    if (total[i] <= threshold) continue;
    if (passes.empty() || static_cast<double>(i - passes.back().last) > longest_dip)
      passes.push_back({i, i, 0.0, 0.0});
    Pass& pass = passes.back();
    pass.last = i;
    pass.weight += total[i];
    pass.moment += total[i] * static_cast<double>(i);
  }
  return passes;
}

// The distance between passes of one obstacle; passes that the recording cuts off do not count.
std::optional<double> period_between_peaks(const TurnSignal& signal, Span plausible) {
  constexpr double dip_share = 0.125;  // of a turn; neighbouring sensors look 25 degrees apart
  std::vector<Pass> passes = find_passes(signal, dip_share * plausible.from);
  if (!passes.empty() && passes.front().first == 0) passes.erase(passes.begin());
  if (!passes.empty() && passes.back().last + 1 == signal.values.size()) passes.pop_back();
  if (passes.size() < 2) return std::nullopt;
  const double period =
      (passes.back().centre() - passes.front().centre()) / static_cast<double>(passes.size() - 1);
  if (period < plausible.from || period > plausible.to) return std::nullopt;
  return period;
}

// In entries of the signal.
Span plausible_lags(const EncoderScaleOptions& options, double recorded) {
  const double expected = options.expected_ticks_per_turn / step_ticks;
  if (expected > 0.0)
    return {expected * (1.0 - options.expected_tolerance), expected * (1.0 + options.expected_tolerance)};
  return {shortest_turn_ticks / step_ticks, recorded / 1.5};
}

std::optional<Refusal> doubt_of_signal(const TurnSignal& signal, Span plausible) {
  const double recorded = static_cast<double>(signal.values.size());
  const double needed = 1.3 * plausible.to;
  if (recorded < needed)
    return Refusal{"only " + rounded(recorded * step_ticks, 0) + " ticks of turning were recorded, but " +
                   rounded(needed * step_ticks, 0) + " are needed; let the robot turn longer"};
  if (signal_to_noise(signal) < min_signal_to_noise)
    return Refusal{"the light bumper sees nothing but noise; put an object within 0.2 m of the robot"};
  return std::nullopt;
}

std::optional<double> find_period(const TurnSignal& signal, Span plausible,
                                  const EncoderScaleOptions& options) {
  if (options.method == PeriodMethod::peak) return period_between_peaks(signal, plausible);
  const std::size_t all = signal.values.size();
  const double near = options.expected_ticks_per_turn > 0.0 ? best_lag(signal, plausible, 1.0, 0, all)
                                                            : first_good_lag(signal, plausible);
  return best_lag(signal, {near - 2.0, near + 2.0}, 0.1, 0, all);
}

std::optional<Refusal> doubt_of_period(double period, double correlation, Span plausible) {
  if (correlation < min_correlation)
    return Refusal{"the light-bumper signal has no clear period: its best repetition matches by " +
                   rounded(correlation, 2) +
                   " of 1; do things move around the robot, does it slip, or are robot.wheel_base_m or "
                   "expected_ticks_per_turn those of another robot, so that it turned by another angle?"};
  if (period < plausible.from + 1.0 || period > plausible.to - 1.0)
    return Refusal{"the best repetition lies at the edge of what is plausible (" +
                   rounded(period * step_ticks, 0) + " ticks per turn); check expected_ticks_per_turn"};
  return std::nullopt;
}

std::vector<CorrelationPoint> match_curve(const TurnSignal& signal, Span plausible) {
  std::vector<CorrelationPoint> curve;
  const double longest = std::min(static_cast<double>(signal.values.size()) / 1.3, 2.2 * plausible.to);
  for (double lag = 1.0; lag < longest; lag += 1.0)
    curve.push_back({lag * step_ticks, match_at_lag(signal, lag, 0, signal.values.size())});
  return curve;
}

}  // namespace

tl::expected<TurnPeriod, Refusal> fit_turn_period(std::span<const TurnSample> samples,
                                                  const EncoderScaleOptions& options) {
  if (samples.size() < 50) return tl::unexpected(Refusal{"the turn was not recorded; did the wheels move?"});
  const TurnSignal signal = resample_turn(samples, step_ticks);
  const double recorded = static_cast<double>(signal.values.size());
  const Span plausible = plausible_lags(options, recorded);
  if (const auto doubt = doubt_of_signal(signal, plausible)) return tl::unexpected(*doubt);
  const auto period = find_period(signal, plausible, options);
  if (!period) {
    return tl::unexpected(
        Refusal{"no single obstacle passes once per turn; use the autocorrelation, leave one object near the "
                "robot, or let it turn longer"});
  }
  TurnPeriod fit;
  fit.correlation = match_at_lag(signal, *period, 0, signal.values.size());
  if (const auto doubt = doubt_of_period(*period, fit.correlation, plausible)) return tl::unexpected(*doubt);
  fit.relative_standard_error = relative_standard_error(periods_of_parts(signal, *period), *period);
  if (fit.relative_standard_error > options.largest_standard_error) {
    return tl::unexpected(Refusal{"one full turn is " + rounded(*period * step_ticks, 0) +
                                  " ticks only to +- " + rounded(100.0 * fit.relative_standard_error, 2) +
                                  " %; put another object near the robot, or let it turn longer"});
  }
  fit.ticks = *period * step_ticks;
  fit.turns = recorded / *period;
  fit.curve = match_curve(signal, plausible);
  return fit;
}

}  // namespace wheelwright
