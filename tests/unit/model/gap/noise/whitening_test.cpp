#include "model/gap/noise/whitening.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/known_errors.hpp"

using namespace wheelwright::gap;
using wheelwright::test::drifting_errors;
using wheelwright::test::known_errors;
using wheelwright::test::with_tracker;

namespace {

double power_of(const std::vector<double>& values) {
  double power = 0.0;
  for (const double value : values) power += value * value;
  return power / static_cast<double>(values.size());
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
  for (const double value : white) CHECK(std::abs(value) < 5.0);
  CHECK(Whitener::sums(known.times_s, known.restarts, noise, {}, known.errors).count == 398);
}

TEST_CASE("Sums of innovations without a filter that is kept are those of the filter's innovations") {
  auto known = known_errors(noise, 400, 6);
  known.restarts[200] = 1;
  for (std::size_t i = 300; i < known.times_s.size(); ++i)
    known.times_s[i] += 0.003 * static_cast<double>(i % 7);
  std::vector<double> unsteady(known.times_s.size());
  for (std::size_t i = 0; i < unsteady.size(); ++i) unsteady[i] = i < 100 ? 0.3 : 1.0;
  const auto infinity = std::numeric_limits<double>::infinity();
  for (const TravelNoise& of : {TravelNoise{1e-3, 2e-3}, TravelNoise{1e-3, 2e-3, 0.1, 3.0},
                                TravelNoise{1e-3, 2e-3, 0.0, infinity, 5e-4, 0.1},
                                TravelNoise{1e-3, 2e-3, 0.1, 3.0, 5e-4, 0.1, 0.5}}) {
    const Whitener whitener(known.times_s, known.restarts, of, unsteady);
    std::vector<double> white(known.errors.size());
    whitener.apply(known.errors, white.data());
    double sum_squares = 0.0;
    for (const double value : white) sum_squares += value * value;
    const InnovationSums sums = Whitener::sums(known.times_s, known.restarts, of, unsteady, known.errors);
    CHECK(sums.sum_squares == Approx(sum_squares).epsilon(1e-12));
    CHECK(sums.log_determinant == Approx(whitener.log_determinant()).epsilon(1e-12));
  }
}

TEST_CASE("Errors whose speed lasts, and which come back, come out white and of unit variance") {
  const TravelNoise lasting{1e-4, 4e-3, 0.12, 3.0};
  const auto known = drifting_errors(lasting, 20000, 8);
  const Whitener whitener(known.times_s, known.restarts, lasting);
  std::vector<double> white(known.errors.size());
  whitener.apply(known.errors, white.data());
  CHECK_THAT(power_of(white), WithinAbs(1.0, 0.04));
  for (const std::size_t lag : {1U, 2U, 5U, 20U, 100U}) {
    INFO("lag " << lag);
    CHECK(std::abs(correlation(white, lag)) < 4.0 / std::sqrt(20000.0));
  }
}

TEST_CASE("Errors that readings have in common for a while come out white and of unit variance") {
  const TravelNoise tracked{
      .reading = 1e-3, .walk_per_sqrt_s = 1e-3, .tracker = 2e-3, .tracker_correlation_time_s = 0.1};
  auto known = with_tracker(known_errors({1e-3, 1e-3}, 20000, 10), 2e-3, 0.1, 11);
  known.restarts[3000] = 1;
  const Whitener whitener(known.times_s, known.restarts, tracked);
  std::vector<double> white(known.errors.size());
  whitener.apply(known.errors, white.data());
  CHECK_THAT(power_of(white), WithinAbs(1.0, 0.04));
  for (const std::size_t lag : {1U, 2U, 5U, 20U, 100U}) {
    INFO("lag " << lag);
    CHECK(std::abs(correlation(white, lag)) < 4.0 / std::sqrt(20000.0));
  }
}

TEST_CASE("A long time is foretold as its parts are") {
  const double return_time_s = GENERATE(3.0, 0.12);  // or as quickly as the speed is forgotten
  const TravelNoise lasting{1e-4, 4e-3, 0.12, return_time_s};
  const DriftStep whole(lasting, 0.3);
  const DriftStep part(lasting, 0.1);
  double travel = 0.0;
  double speed = 1.0;
  double travel_variance = 0.0;
  double covariance = 0.0;
  double speed_variance = 0.0;
  for (int i = 0; i < 3; ++i) {
    travel = part.kept * travel + part.carry_s * speed;
    speed *= part.decay;
    const double ahead = part.kept * covariance + part.carry_s * speed_variance;
    travel_variance = part.kept * (part.kept * travel_variance + part.carry_s * covariance) +
                      part.carry_s * ahead + part.travel_variance;
    covariance = part.decay * ahead + part.covariance;
    speed_variance = part.decay * part.decay * speed_variance + part.speed_variance;
  }
  CHECK_THAT(whole.travel_variance, WithinRel(travel_variance, 1e-6));
  CHECK_THAT(whole.covariance, WithinRel(covariance, 1e-6));
  CHECK_THAT(whole.speed_variance, WithinRel(speed_variance, 1e-6));
  CHECK_THAT(whole.carry_s, WithinRel(travel, 1e-9));
  CHECK_THAT(whole.decay, WithinRel(speed, 1e-9));
}

TEST_CASE("A walk that is smaller where commands are steady comes out white in both") {
  const TravelNoise noise_here{.reading = 2e-4, .walk_per_sqrt_s = 3e-3, .steady_share = 0.25};
  const auto reading = known_errors({2e-4, 0.0}, 20000, 15);
  const auto walk = known_errors({0.0, 3e-3}, 20000, 16);
  std::vector<double> errors(reading.errors.size());
  std::vector<double> unsteady(errors.size());
  double walked = 0.0;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    unsteady[i] = i / 300 % 2 == 0 ? 1.0 : 0.0;
    walked += (unsteady[i] == 1.0 ? 1.0 : 0.25) * (walk.errors[i] - walk.errors[i - 1]);
    errors[i] = walked + reading.errors[i];
  }
  const Whitener whitener(reading.times_s, reading.restarts, noise_here, unsteady);
  std::vector<double> white(errors.size());
  whitener.apply(errors, white.data());
  std::vector<double> in_steady;
  std::vector<double> in_unsteady;
  for (std::size_t i = 1; i < white.size(); ++i)
    (unsteady[i] == 1.0 ? in_unsteady : in_steady).push_back(white[i]);
  CHECK_THAT(power_of(in_steady), WithinAbs(1.0, 0.06));  // 4 deviations
  CHECK_THAT(power_of(in_unsteady), WithinAbs(1.0, 0.06));
  CHECK(std::abs(correlation(white, 1)) < 4.0 / std::sqrt(20000.0));
}
