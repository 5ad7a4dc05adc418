#include "model/gap/whitening.hpp"

#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright::gap;

namespace {

// Errors of travel by a known random walk and known reading noise.
struct KnownErrors {
  std::vector<double> times_s;
  std::vector<char> restarts;
  std::vector<double> errors;
};

KnownErrors known_errors(const TravelNoise& noise, std::size_t count, std::uint64_t seed) {
  constexpr double step_s = 0.018;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  KnownErrors known;
  double walked = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) walked += noise.walk_per_sqrt_s * std::sqrt(step_s) * normal(random);
    known.times_s.push_back(step_s * static_cast<double>(i));
    known.restarts.push_back(0);
    known.errors.push_back(walked + noise.reading * normal(random));
  }
  return known;
}

double correlation(const std::vector<double>& values, std::size_t lag) {
  double sum = 0.0;
  double power = 0.0;
  for (std::size_t i = lag; i < values.size(); ++i) sum += values[i] * values[i - lag];
  for (const double value : values) power += value * value;
  return sum / power;
}

constexpr TravelNoise noise{2e-4, 3e-3};

}  // namespace

TEST_CASE("Errors of a known random walk come out white and of unit variance") {
  const auto known = known_errors(noise, 20000, 5);
  const Whitener whitener(known.times_s, known.restarts, noise);
  std::vector<double> white(known.errors.size());
  whitener.apply(known.errors, white.data());

  double power = 0.0;
  for (const double value : white) power += value * value;
  CHECK_THAT(power / static_cast<double>(white.size()), WithinAbs(1.0, 0.04));  // 4 deviations
  for (const std::size_t lag : {1U, 2U, 5U, 20U}) {
    INFO("lag " << lag);
    CHECK(std::abs(correlation(white, lag)) < 4.0 / std::sqrt(20000.0));
  }
}

TEST_CASE("What is not known of the start of a series, or after a restart, counts for nothing") {
  auto known = known_errors(noise, 400, 6);
  known.restarts[200] = 1;
  for (std::size_t i = 200; i < known.errors.size(); ++i) known.errors[i] += 5.0;
  const Whitener whitener(known.times_s, known.restarts, noise);
  std::vector<double> white(known.errors.size());
  whitener.apply(known.errors, white.data());
  CHECK(white[0] == 0.0);
  CHECK(white[200] == 0.0);
  CHECK(whitener.innovations() == 398);
  for (const double value : white) CHECK(std::abs(value) < 5.0);
}

TEST_CASE("The noise of a series is found from the series") {
  const auto known = known_errors(noise, 20000, 7);
  const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
  const TravelNoise found = noise_of(samples, 1e-6);
  // Walk over reading is looked for in steps of a quarter of a decade.
  const double step = std::pow(10.0, 0.25);
  CHECK(found.walk_per_sqrt_s / found.reading < step * noise.walk_per_sqrt_s / noise.reading);
  CHECK(found.walk_per_sqrt_s / found.reading > noise.walk_per_sqrt_s / noise.reading / step);
  CHECK_THAT(found.walk_per_sqrt_s, WithinRel(noise.walk_per_sqrt_s, step - 1.0));
}
