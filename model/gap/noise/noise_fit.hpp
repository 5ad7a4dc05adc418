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

// How long the speed of what drifts may last: of motors, and of what sways. Readings that lie far apart do
// not tell; then it is a random walk.
constexpr double no_lasting_s = 0.0;
constexpr double lasting_of_motors_s = 0.25;
constexpr double lasting_of_swaying_s = 1.0;

struct NoiseLimits {
  double smallest_reading;  // the least that a reading can err (its quantisation)
  double longest_lasting_s;
  bool tracked = false;  // by references, which may err alike for a while
};

// The noise under which the series are most likely; all series of one channel together. Where they are
// tracked, noise that lasts must not come to more between readings half a second and two seconds apart than
// these show: smooth references make quick errors look as if the travel's speed lasted.
TravelNoise noise_of(std::span<const NoiseSample> samples, const NoiseLimits& limits);

}  // namespace wheelwright::gap
