// A residual that drifts further than noise does.
#pragma once

#include <optional>
#include <span>

#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

// How far sound robots drift within a second, as a log-normal distribution.
struct DriftPrior {
  double median_per_sqrt_s;  // m or rad
  double log_deviation;
};

struct Drift {
  double p_value = 1.0;
  double rate_per_sqrt_s = 0.0;  // of a random walk, m or rad
  double size = 0.0;             // root mean square over 10 s, m or rad
};

// The rate is that of the random walk with white reading noise under which readings two seconds apart are
// most likely; the p-value is the share of sound robots that drift further. None where there are too few
// readings.
std::optional<Drift> drift(std::span<const ResidualTrack* const> tracks, const DriftPrior& prior);

}  // namespace wheelwright::gap
