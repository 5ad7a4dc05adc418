// Which noise the errors of free runs are most likely under.
#pragma once

#include <span>
#include <vector>

#include "model/gap/noise/whitening.hpp"

namespace wheelwright::gap {

struct NoiseSample {
  std::span<const double> times_s;
  std::span<const char> restarts;
  std::span<const double> errors;
  std::span<const double> unsteady{};  // as for Whitener
};

struct ErrorSeries {
  std::vector<double> times_s;
  std::vector<char> restarts;
  std::vector<double> errors;
  std::vector<double> unsteady;

  NoiseSample sample() const { return {times_s, restarts, errors, unsteady}; }
};

// Only readings that lie so far behind the one before, and those behind which nothing is known.
ErrorSeries thinned(const NoiseSample& all, double min_apart_s);

// Largest correlation time of the speed of a drift: none where readings lie far apart, which do not show it
// (the drift is a random walk then), of motors, and of what oscillates.
constexpr double no_correlation_time_s = 0.0;
constexpr double motor_correlation_time_s = 0.25;
constexpr double oscillation_correlation_time_s = 1.0;

struct NoiseLimits {
  double smallest_reading;  // the least that a reading can err (its quantisation)
  double max_correlation_time_s;
  bool tracked = false;  // by references, which may err alike for a while
};

// The noise under which the series are most likely, all series of one channel together: it maximises
//
//   ln L = -1/2 sum_k (e_k / s_k)^2 - sum_k ln s_k,    e_k: innovation before scaling, s_k: its deviation
//
// For tracked references the variance that is predicted between readings 0.5 s and 2 s apart must not exceed
// what they show; otherwise a smoothed reference looks like a drift whose speed is correlated.
TravelNoise noise_of(std::span<const NoiseSample> samples, const NoiseLimits& limits);

}  // namespace wheelwright::gap
