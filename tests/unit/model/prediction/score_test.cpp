#include "model/prediction/score.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.1;

// A robot that really drives straight at 0.2 m/s, seen by encoders of 0.1 mm and by an outside reference, and
// a prediction whose wheels are wrong by `error_m_s`.
struct Example {
  DriveLog log;
  std::vector<PredictedMotion> predicted;
};

Example straight_run(std::size_t rows, const WheelPair& error_m_s) {
  Example example;
  example.log.wheel_base_m = 0.25;
  example.log.period_s = period_s;
  example.log.metres_per_tick = WheelPair{1e-4, 1e-4};
  const WheelPair speed{0.2 + error_m_s.left, 0.2 + error_m_s.right};
  const Twist twist = twist_of_wheels(speed, 0.25);
  for (std::size_t k = 0; k < rows; ++k) {
    const double t = period_s * static_cast<double>(k);
    DriveSample sample;
    sample.t_s = t;
    sample.ticks = WheelTicks{std::llround(2000.0 * t), std::llround(2000.0 * t)};
    sample.reference_x_m = 5.0;
    sample.reference_y_m = 0.2 * t;
    sample.reference_theta_rad = std::numbers::pi / 2.0;
    example.log.samples.push_back(sample);
    example.predicted.push_back(
        {t, speed, twist, {speed.left * t, speed.right * t}, move_along_arc({}, twist, t)});
  }
  return example;
}

Score score_of(const Example& example) {
  return score_run(example.predicted, example.log);
}

}  // namespace

TEST_CASE("A perfect prediction scores zero in every figure, whatever frame the reference has") {
  const Score score = score_of(straight_run(201, {0.0, 0.0}));
  CHECK_THAT(*score.wheel_speed_rms_m_s, WithinAbs(0.0, 1e-12));
  CHECK_THAT(*score.distance_rms_m, WithinAbs(0.0, 1e-12));
  CHECK_THAT(score.position_rms_m->value, WithinAbs(0.0, 1e-12));
  CHECK_THAT(score.heading_rms_rad->value, WithinAbs(0.0, 1e-12));
  CHECK(score.position_rms_m->horizon_s == 10.0);
}

TEST_CASE("A constant speed error has the analytic RMS in speed, distance and position") {
  const Example example = straight_run(201, {0.01, 0.01});
  const Score score = score_of(example);
  CHECK_THAT(*score.wheel_speed_rms_m_s, WithinAbs(0.01, 1e-12));
  // The root mean square of 0.01 * 0.1 * k over k = 1..n is 0.001 sqrt((n+1)(2n+1)/6).
  CHECK_THAT(*score.distance_rms_m, WithinAbs(0.001 * std::sqrt(201.0 * 401.0 / 6.0), 1e-12));
  CHECK_THAT(score.position_rms_m->value, WithinAbs(0.1, 1e-9));
  CHECK_THAT(end_distance_error_m(example.predicted, example.log)->left, WithinAbs(0.2, 1e-9));
}

TEST_CASE("Travel begins again where counts were lost") {
  Example example = straight_run(201, {0.0, 0.0});
  for (std::size_t k = 100; k < 201; ++k) example.log.samples[k].ticks->left -= 500;
  CHECK(*score_of(example).distance_rms_m > 0.02);
  example.log.samples[100].counter_reset = true;
  CHECK_THAT(*score_of(example).wheel_speed_rms_m_s, WithinAbs(0.0, 1e-12));
  CHECK_THAT(*score_of(example).distance_rms_m, WithinAbs(0.0, 1e-12));
}

TEST_CASE("An error of one wheel counts half in the squares of both") {
  const Score score = score_of(straight_run(201, {0.0, 0.02}));
  CHECK_THAT(*score.wheel_speed_rms_m_s, WithinAbs(0.02 / std::sqrt(2.0), 1e-12));
  CHECK_THAT(score.heading_rms_rad->value, WithinAbs(0.02 / 0.25 * 10.0, 1e-9));
}

TEST_CASE("Full turns of difference in heading do not count") {
  Example example = straight_run(101, {0.0, 0.0});
  for (std::size_t k = 50; k < example.log.samples.size(); ++k) {
    *example.log.samples[k].reference_theta_rad -= 4.0 * std::numbers::pi;
  }
  CHECK_THAT(score_of(example).heading_rms_rad->value, WithinAbs(0.0, 1e-9));
}

TEST_CASE("The horizon is the span of a short run, and of poses on the first and last row only") {
  CHECK_THAT(score_of(straight_run(41, {0.01, 0.01})).position_rms_m->horizon_s, WithinAbs(4.0, 1e-9));
  Example example = straight_run(301, {0.01, 0.01});
  for (std::size_t k = 1; k + 1 < example.log.samples.size(); ++k) {
    example.log.samples[k].reference_x_m.reset();
    example.log.samples[k].reference_y_m.reset();
    if (k % 10 != 0) example.log.samples[k].reference_theta_rad.reset();
  }
  const Score score = score_of(example);
  CHECK_THAT(score.position_rms_m->horizon_s, WithinAbs(30.0, 1e-9));
  CHECK_THAT(score.position_rms_m->value, WithinAbs(0.3, 1e-9));
  CHECK_THAT(score.heading_rms_rad->horizon_s, WithinAbs(10.0, 1e-9));
}

TEST_CASE("What the log cannot show is absent") {
  Example example = straight_run(101, {0.0, 0.0});
  for (auto& sample : example.log.samples) sample.ticks.reset();
  Score score = score_of(example);
  CHECK_FALSE(score.wheel_speed_rms_m_s);
  CHECK_FALSE(score.distance_rms_m);
  CHECK_FALSE(end_distance_error_m(example.predicted, example.log));
  CHECK(score.position_rms_m);
  for (auto& sample : example.log.samples) sample.reference_x_m.reset();
  score = score_of(example);
  CHECK_FALSE(score.position_rms_m);
  CHECK(score.heading_rms_rad);
  for (auto& sample : example.log.samples) sample.reference_theta_rad.reset();
  CHECK(score_of(example).empty());
}

TEST_CASE("Runs are pooled by their sums of squares") {
  const Example good = straight_run(101, {0.0, 0.0});
  const Example bad = straight_run(301, {0.02, 0.02});
  ScoreSums sums;
  sums.add(good.predicted, good.log);
  sums.add(bad.predicted, bad.log);
  CHECK_THAT(*sums.score().wheel_speed_rms_m_s, WithinAbs(0.02 * std::sqrt(0.75), 1e-12));
}
