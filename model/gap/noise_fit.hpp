// Which noise the errors of free runs are most likely under.
#pragma once

#include <span>
#include <vector>

#include "model/gap/whitening.hpp"

namespace wheelwright::gap {

struct NoiseSample {
  std::span<const double> times_s;
  std::span<const char> restarts;
  std::span<const double> errors;
};

struct ErrorSeries {
  std::vector<double> times_s;
  std::vector<char> restarts;
  std::vector<double> errors;

  NoiseSample sample() const { return {times_s, restarts, errors}; }
};

// Only readings that lie so far behind the one before, and those behind which nothing is known.
ErrorSeries thinned(const NoiseSample& all, double least_apart_s);

// How long the speed of what wanders may last: of motors, and of what sways. Readings that lie far apart do
// not tell; then it is a random walk.
constexpr double no_lasting_s = 0.0;
constexpr double lasting_of_motors_s = 0.25;
constexpr double lasting_of_swaying_s = 1.0;

// The noise under which the series are most likely; all series of one channel together. `smallest_reading` is
// the least that a reading can err (its quantisation). Noise that lasts must not come to more between
// readings half a second and two seconds apart than these show: smooth references make quick errors look as
// if they lasted, too.
TravelNoise noise_of(std::span<const NoiseSample> samples, double smallest_reading, double longest_lasting_s);

}  // namespace wheelwright::gap
