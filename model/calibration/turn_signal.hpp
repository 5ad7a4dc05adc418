// The light-bumper signals of a turn in place, resampled over turning ticks.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/calibration/encoder_scale_fit.hpp"

namespace wheelwright {

struct TurnSignal {
  static constexpr std::size_t sensors = 6;
  double step_ticks = 0.0;                          // distance between entries
  std::vector<std::array<double, sensors>> values;  // mean of each sensor removed
  std::array<double, sensors> weight{};             // 1 / noise variance, so that bright noise does not rule
};

// The stretches in which the robot turned one way and back; `second` is empty where it did not turn back.
struct TurnWays {
  std::span<const TurnSample> first;
  std::span<const TurnSample> second;
};
TurnWays split_at_reversal(std::span<const TurnSample> samples);

// Resamples on a uniform grid of turning ticks, that is, half the difference of the two wheels' counts.
TurnSignal resample_turn(std::span<const TurnSample> samples, double step_ticks);

// Match of the signal with itself at a lag (in entries, may be fractional), over entries [first, last): the
// cosine between both, which is 1 for a perfect repetition, also where a robot that slid away from the object
// sees it dimmer.
double match_at_lag(const TurnSignal& signal, double lag, std::size_t first, std::size_t last);

}  // namespace wheelwright
