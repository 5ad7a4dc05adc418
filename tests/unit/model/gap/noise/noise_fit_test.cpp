#include "model/gap/noise/noise_fit.hpp"

#include <cmath>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/support/known_errors.hpp"

using namespace wheelwright::gap;
using wheelwright::test::drifting_errors;
using wheelwright::test::known_errors;
using wheelwright::test::KnownErrors;
using wheelwright::test::with_tracker;

namespace {

constexpr TravelNoise noise{2e-4, 3e-3};

// A tracker that smooths its readings: they err alike for some periods.
KnownErrors with_smooth_readings(KnownErrors known, double deviation, double smooth_s, std::uint64_t seed) {
  const double kept = std::exp(-wheelwright::test::reading_step_s / smooth_s);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  double first = 0.0;
  double second = 0.0;
  for (double& error : known.errors) {
    first = kept * first + (1.0 - kept) * normal(random);
    second = kept * second + (1.0 - kept) * first;
    error += deviation / (1.0 - kept) * second;
  }
  return known;
}

}  // namespace

TEST_CASE("The noise of a series is found from the series") {
  const auto known = known_errors(noise, 20000, 7);
  const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
  const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s});
  // Walk over reading is looked for in steps of a quarter of a decade.
  const double step = std::pow(10.0, 0.25);
  CHECK(found.walk_per_sqrt_s / found.reading < step * noise.walk_per_sqrt_s / noise.reading);
  CHECK(found.walk_per_sqrt_s / found.reading > noise.walk_per_sqrt_s / noise.reading / step);
  CHECK_THAT(found.walk_per_sqrt_s, WithinRel(noise.walk_per_sqrt_s, step - 1.0));
}

TEST_CASE("How long a speed lasts, and that travel comes back, is found from the series") {
  const TravelNoise truth{1e-4, 4e-3, 0.12, 3.0};
  const auto known = drifting_errors(truth, 20000, 9);
  const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
  const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s});
  CHECK(found.drift_correlation_time_s == truth.drift_correlation_time_s);
  CHECK(found.return_time_s == truth.return_time_s);
  CHECK_THAT(found.walk_per_sqrt_s, WithinRel(truth.walk_per_sqrt_s, 0.4));
}

TEST_CASE("A random walk is not taken for a speed that lasts, nor for travel that comes back") {
  for (const std::uint64_t seed : {10U, 11U, 12U, 13U}) {
    const auto known = known_errors(noise, 20000, seed);
    const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
    const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s});
    CHECK(found.drift_correlation_time_s == 0.0);
    CHECK(std::isinf(found.return_time_s));
  }
}

TEST_CASE("References that are smoothed do not make noise come to more over seconds than it does") {
  for (const std::uint64_t seed : {14U, 15U, 16U}) {
    const auto known = with_smooth_readings(known_errors({4e-4, 1e-2}, 20000, seed), 8e-3, 0.12, seed + 10);
    const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
    const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s, true});
    CHECK(found.walk_per_sqrt_s <
          2.0 * 1e-2);  // noise that lasts would come to three times as much as there is
  }
}

TEST_CASE("What readings of a tracker err alike is told from the travel that wanders") {
  struct Truth {
    double reading, walk, tracker, drift_correlation_time_s;
  };
  const auto truth =
      GENERATE(Truth{1e-3, 1e-3, 1e-3, 0.1}, Truth{1e-3, 4e-3, 3e-3, 0.2}, Truth{2e-4, 1e-3, 3e-3, 0.1});
  const auto known = with_tracker(known_errors({truth.reading, truth.walk}, 20000, 17), truth.tracker,
                                  truth.drift_correlation_time_s, 18);
  const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
  const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s, true});
  CHECK_THAT(found.tracker, WithinRel(truth.tracker, 0.25));
  CHECK_THAT(found.walk_per_sqrt_s, WithinRel(truth.walk, 0.25));
  CHECK(found.tracker_correlation_time_s == truth.drift_correlation_time_s);
}

TEST_CASE("White readings and a walk are not taken for a tracker") {
  for (const std::uint64_t seed : {19U, 20U, 21U}) {
    const auto known = known_errors(noise, 20000, seed);
    const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors}};
    CHECK(noise_of(samples, {1e-6, motor_correlation_time_s, true}).tracker == 0.0);
  }
}

namespace {

// A random walk that goes quicker for five seconds, then slower for five.
struct UnsteadyErrors {
  KnownErrors known;
  std::vector<double> unsteady;
};

UnsteadyErrors unsteady_errors(double steady_share, std::uint64_t seed) {
  UnsteadyErrors result{known_errors({2e-4, 3e-3}, 20000, seed), {}};
  std::mt19937_64 random(seed + 1);
  std::normal_distribution<double> normal;
  double walked = 0.0;
  for (std::size_t i = 0; i < result.known.errors.size(); ++i) {
    const bool unsteady = static_cast<int>(result.known.times_s[i] / 5.0) % 2 == 0;
    const double walk = (unsteady ? 1.0 : steady_share) * 3e-3;
    walked += walk * std::sqrt(wheelwright::test::reading_step_s) * normal(random);
    result.known.errors[i] = walked + 2e-4 * normal(random);
    result.unsteady.push_back(unsteady ? 1.0 : 0.0);
  }
  return result;
}

}  // namespace

TEST_CASE("How much less travel drifts where commands are steady is found from the series") {
  for (const double steady_share : {0.17, 0.35}) {
    const auto [known, unsteady] = unsteady_errors(steady_share, 31);
    const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors, unsteady}};
    const TravelNoise found = noise_of(samples, {1e-6, motor_correlation_time_s});
    CHECK_THAT(found.steady_share, WithinAbs(steady_share, 1e-9));
    CHECK_THAT(found.walk_per_sqrt_s, WithinRel(3e-3, 0.3));
  }
}

TEST_CASE("A robot that drifts alike everywhere is not said to drift less where commands are steady") {
  for (const std::uint64_t seed : {41U, 42U, 43U}) {
    const auto [known, unsteady] = unsteady_errors(1.0, seed);
    const std::vector<NoiseSample> samples{{known.times_s, known.restarts, known.errors, unsteady}};
    CHECK(noise_of(samples, {1e-6, motor_correlation_time_s}).steady_share == 1.0);
  }
}

TEST_CASE("A series of far readings keeps the share of unsteady time between them") {
  const std::vector<double> times_s{0.0, 0.1, 0.2, 0.3, 0.4};
  const std::vector<char> restarts(5, 0);
  const std::vector<double> errors(5, 0.0);
  const std::vector<double> unsteady{0.0, 1.0, 0.0, 0.0, 0.5};
  const ErrorSeries far = thinned({times_s, restarts, errors, unsteady}, 0.19);
  REQUIRE(far.unsteady.size() == 3);
  CHECK_THAT(far.unsteady[1], WithinAbs(0.5, 1e-12));
  CHECK_THAT(far.unsteady[2], WithinAbs(0.25, 1e-12));
}
