#include "model/gap/adequacy/drift.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/noise/noise_fit.hpp"

namespace wheelwright::gap {
namespace {

constexpr double apart_s = 2.0;
constexpr std::size_t min_readings = 20;

}  // namespace

std::optional<Drift> drift(std::span<const ResidualTrack* const> tracks, const DriftPrior& prior) {
  std::vector<ErrorSeries> series;
  std::size_t readings = 0;
  for (const ResidualTrack* track : tracks) {
    series.push_back(thinned({track->time_s, track->discontinuity, track->error}, apart_s));
    readings += series.back().times_s.size();
  }
  if (readings < min_readings) return std::nullopt;
  std::vector<NoiseSample> samples;
  samples.reserve(series.size());
  for (const ErrorSeries& one : series) samples.push_back(one.sample());
  const TravelNoise noise =
      noise_of(samples, {.smallest_reading = 0.0, .max_correlation_time_s = no_correlation_time_s});
  Drift found;
  found.rate_per_sqrt_s = noise.walk_per_sqrt_s;
  found.size = noise.walk_per_sqrt_s * std::sqrt(horizon_s);
  const double deviations =
      std::log(std::max(found.rate_per_sqrt_s, 1e-9) / prior.median_per_sqrt_s) / prior.log_deviation;
  found.p_value = 0.5 * std::erfc(deviations / std::sqrt(2.0));
  return found;
}

}  // namespace wheelwright::gap
