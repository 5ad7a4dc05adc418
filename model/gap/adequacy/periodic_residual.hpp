// A residual that repeats itself, over time or over a wheel's travel.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

struct PeriodicResidual {
  enum class Over { time, travel } over = Over::time;
  double period = 0.0;     // s or m
  double amplitude = 0.0;  // of the free-run error, m or rad: see swing_amplitude.hpp
  double share = 0.0;      // of the error's mean square within four periods
  std::vector<std::pair<double, double>>
      folded;            // position within a period, mean error there; where it swings most
  double p_value = 1.0;  // of a peak as high anywhere among the frequencies
};

// The highest peak of the periodogram of the innovations, summed over tracks with a phase of its own in each.
// With T tracks, twice the power at a frequency is chi-squared with 2 T degrees of freedom where innovations
// are white; each innovation is taken beyond its correlation with the one before, and power is measured
// against the median of its neighbourhood, so that noise of another colour has no peak. Periods from 0.2 s
// (or three readings, or 12 mm) up to a quarter of the longest run. `at` holds where each reading of each
// track stands, s or m. None where the runs are too short.
std::optional<PeriodicResidual> periodic_residual(std::span<const ResidualTrack* const> tracks,
                                                  std::span<const std::vector<double>> at,
                                                  PeriodicResidual::Over over);

}  // namespace wheelwright::gap
