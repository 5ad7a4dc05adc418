#include "model/gap/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
namespace {

// Log likelihood of the samples for a ratio of walk to reading noise, with their common size chosen at its
// best.
struct Profile {
  double log_likelihood;
  double size;  // by which both noises have to be multiplied
};

Profile profile(std::span<const NoiseSample> samples, const TravelNoise& shape) {
  double squares = 0.0;
  double log_determinant = 0.0;
  std::size_t count = 0;
  std::vector<double> innovations;
  for (const auto& sample : samples) {
    const Whitener whitener(sample.times_s, sample.restarts, shape);
    innovations.assign(sample.errors.size(), 0.0);
    whitener.apply(sample.errors, innovations.data());
    for (const double innovation : innovations) squares += innovation * innovation;
    log_determinant += whitener.log_determinant();
    count += whitener.innovations();
  }
  if (count == 0) return {0.0, 1.0};
  const double n = static_cast<double>(count);
  const double variance = std::max(squares / n, 1e-30);
  return {-0.5 * n * std::log(variance) - log_determinant, std::sqrt(variance)};
}

}  // namespace

Whitener::Whitener(std::span<const double> times_s, std::span<const char> restarts,
                   const TravelNoise& noise) {
  const double reading = noise.reading * noise.reading;
  const double walk = noise.walk_per_sqrt_s * noise.walk_per_sqrt_s;
  double variance = 0.0;  // of the estimated error, after the reading before
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (i == 0 || restarts[i]) {
      steps_.push_back({1.0, 0.0});
      variance = reading;
      continue;
    }
    const double expected = variance + walk * (times_s[i] - times_s[i - 1]);
    const double innovation = expected + reading;
    const double gain = expected / innovation;
    const double deviation = std::sqrt(innovation);
    steps_.push_back({gain, 1.0 / deviation});
    variance = (1.0 - gain) * expected;
    log_determinant_ += std::log(deviation);
    ++count_;
  }
}

void Whitener::apply(std::span<const double> errors, double* innovations) const {
  double estimate = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double innovation = errors[i] - estimate;
    estimate += steps_[i].gain * innovation;
    innovations[i] = innovation * steps_[i].scale;
  }
}

TravelNoise noise_of(std::span<const NoiseSample> samples, double smallest_reading) {
  constexpr int steps = 24;
  constexpr double smallest_ratio = 1e-3;  // walk in one second over reading
  constexpr double largest_ratio = 1e3;
  TravelNoise best{1.0, smallest_ratio};
  Profile best_profile = profile(samples, best);
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const TravelNoise shape{1.0, smallest_ratio * std::pow(largest_ratio / smallest_ratio, share)};
    const Profile found = profile(samples, shape);
    if (found.log_likelihood > best_profile.log_likelihood) {
      best = shape;
      best_profile = found;
    }
  }
  TravelNoise noise{best_profile.size, best_profile.size * best.walk_per_sqrt_s};
  noise.reading = std::max(noise.reading, smallest_reading);
  noise.walk_per_sqrt_s = std::max(noise.walk_per_sqrt_s, 1e-3 * smallest_reading);
  return noise;
}

}  // namespace wheelwright::gap
