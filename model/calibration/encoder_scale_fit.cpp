#include "model/calibration/encoder_scale_fit.hpp"

#include <cmath>
#include <numbers>

#include "model/calibration/turn_period.hpp"
#include "model/calibration/turn_signal.hpp"

namespace wheelwright {
namespace {

// Share of the drift that is left in the mean (root mean square), as the robot and the objects are elsewhere
// on the way back. From simulated slopes of 2 to 6 cm per metre with one object.
constexpr double drift_left = 0.1;

// Of turning one way, where the robot turned one way only.
EncoderScaleFit of_one_way(const TurnPeriod& way) {
  EncoderScaleFit fit;
  fit.ticks_per_turn = way.ticks;
  fit.relative_standard_error = way.relative_standard_error;
  fit.correlation = way.correlation;
  fit.turns = way.turns;
  fit.curve = way.curve;
  return fit;
}

// The plain mean: a weighted one would not cancel the drift.
EncoderScaleFit of_both_ways(const TurnPeriod& first, const TurnPeriod& back) {
  EncoderScaleFit fit = of_one_way(first);
  fit.drift = 0.5 * (first.ticks - back.ticks) / (0.5 * (first.ticks + back.ticks));
  fit.ticks_per_turn = 0.5 * (first.ticks + back.ticks);
  fit.relative_standard_error = std::hypot(
      0.5 * std::hypot(first.relative_standard_error, back.relative_standard_error), drift_left * *fit.drift);
  fit.correlation = 0.5 * (first.correlation + back.correlation);
  fit.turns = first.turns + back.turns;
  return fit;
}

}  // namespace

tl::expected<EncoderScaleFit, Refusal> fit_encoder_scale(std::span<const TurnSample> samples,
                                                         const EncoderScaleOptions& options) {
  const auto ways = split_at_reversal(samples);
  const auto first = fit_turn_period(ways.first, options);
  if (!first) return tl::unexpected(first.error());
  EncoderScaleFit fit;
  if (ways.second.empty()) {
    fit = of_one_way(*first);
  } else {
    const auto back = fit_turn_period(ways.second, options);
    if (!back) {
      return tl::unexpected(Refusal{
          "on the way back (if the robot slid while it turned, put objects on several sides of it): " +
          back.error().reason});
    }
    fit = of_both_ways(*first, *back);
  }
  // A full turn is the sum of both wheels' travels over the wheel base, whatever the share of each; which of
  // two unlike wheels is the larger one cannot be seen from it.
  const double scale = std::numbers::pi * options.wheel_base_m / fit.ticks_per_turn;
  fit.metres_per_tick = {scale, scale};
  return fit;
}

}  // namespace wheelwright
