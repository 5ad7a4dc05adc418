// Errors of travel whose noise is known.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/gap/noise/whitening.hpp"

namespace wheelwright::test {

constexpr double reading_step_s = 0.018;

struct KnownErrors {
  std::vector<double> times_s;
  std::vector<char> restarts;
  std::vector<double> errors;
};

// A random walk and reading noise.
inline KnownErrors known_errors(const gap::TravelNoise& noise, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  KnownErrors known;
  double walked = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) walked += noise.walk_per_sqrt_s * std::sqrt(reading_step_s) * normal(random);
    known.times_s.push_back(reading_step_s * static_cast<double>(i));
    known.restarts.push_back(0);
    known.errors.push_back(walked + noise.reading * normal(random));
  }
  return known;
}

// A speed that lasts, and travel that comes back; made in steps so small that no formula for long ones is
// needed.
inline KnownErrors drifting_errors(const gap::TravelNoise& noise, std::size_t count, std::uint64_t seed) {
  constexpr int fine = 40;
  constexpr double fine_s = reading_step_s / fine;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  KnownErrors known;
  double speed = 0.0;
  double travel = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    known.times_s.push_back(reading_step_s * static_cast<double>(i));
    known.restarts.push_back(0);
    known.errors.push_back(travel + noise.reading * normal(random));
    for (int k = 0; k < fine; ++k) {
      const double push = noise.walk_per_sqrt_s * std::sqrt(fine_s) * normal(random);
      travel += fine_s * (speed - travel / noise.return_time_s);
      speed += (push - fine_s * speed) / noise.drift_correlation_time_s;
    }
  }
  return known;
}

// Readings of a tracker that err alike for a while.
inline KnownErrors with_tracker(KnownErrors known, double deviation, double drift_correlation_time_s,
                                std::uint64_t seed) {
  const double kept = std::exp(-reading_step_s / drift_correlation_time_s);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  double alike = deviation * normal(random);
  for (double& error : known.errors) {
    error += alike;
    alike = kept * alike + deviation * std::sqrt(1.0 - kept * kept) * normal(random);
  }
  return known;
}

}  // namespace wheelwright::test
