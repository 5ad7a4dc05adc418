#include "model/prediction/open_loop_runs.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.1;

// A robot that drives straight ahead for a minute, 0.2 m/s until it comes to a narrow rug along its way, 3 m
// on, and 0.1 m/s on it. Seen by encoders and by an outside reference.
DriveLog onto_the_rug() {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{1e-4, 1e-4};
  for (int k = 0; k <= 600; ++k) {
    const double t = period_s * k;
    const double x = t < 15.0 ? 0.2 * t : 3.0 + 0.1 * (t - 15.0);
    DriveSample sample;
    sample.t_s = t;
    sample.command_m_s = WheelPair{0.2, 0.2};
    sample.ticks = WheelTicks{std::llround(1e4 * x), std::llround(1e4 * x)};
    sample.reference_x_m = x;
    sample.reference_y_m = 0.0;
    sample.reference_theta_rad = 0.0;
    log.samples.push_back(sample);
  }
  return log;
}

// Knows the rug, and turns by 2 mrad/s as the robot does not: after half a minute it has left the rug.
RobotModel drifting_model(std::vector<AddedEffect> effects) {
  RobotModel model;
  model.linear_part = {ModelType::arma, period_s, 0.25, {{1.0}, {0.0}, {}}, {{0.0}, {1.0025}, {}}};
  model.effects = std::move(effects);
  return model;
}

AddedEffect rug() {
  AddedEffect effect;
  effect.setting = {"surface_patch", "wheel", {-0.5, 13.0, 0.0, 20.0, 0.2, 0.0, 0.0}};
  return effect;
}

// A robot straight ahead for a minute, on wheels that ripple by 30 % once in 0.22 m of way.
DriveLog on_rippling_wheels() {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{1e-5, 1e-5};
  constexpr double fine_s = 1e-3;
  constexpr double per_metre = 2.0 * std::numbers::pi / 0.22;
  double way_m = 0.0;
  for (int k = 0; k <= 600; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = WheelPair{0.2, 0.2};
    sample.ticks = WheelTicks{std::llround(1e5 * way_m), std::llround(1e5 * way_m)};
    log.samples.push_back(sample);
    for (int i = 0; i < 100; ++i) way_m += fine_s * 0.2 * (1.0 + 0.3 * std::sin(per_metre * way_m));
  }
  return log;
}

// Knows the ripple, and that wheels are 2 % faster than they are: after a minute they are a whole turn ahead.
RobotModel hasty_model() {
  AddedEffect ripple;
  ripple.setting = {"wheel_eccentricity", "wheel", {0.3, 0.0, 0.3, 0.0, 0.22}};
  RobotModel model;
  model.linear_part = {ModelType::arma, period_s, 0.25, {{1.02}, {0.0}, {}}, {{0.0}, {1.02}, {}}};
  model.effects = {ripple};
  return model;
}

Score open_loop_score(const RobotModel& model, const DriveLog& log) {
  ScoreSums sums;
  add_open_loop(model, log, sums);
  return sums.score();
}

}  // namespace

TEST_CASE("An effect of place is judged by windows that begin where the robot is, not where a run strayed") {
  const DriveLog log = onto_the_rug();
  const RobotModel model = drifting_model({rug()});
  const Score plain = score_run(free_run(model, log), log);
  CHECK(plain.position_rms_m->value > 0.3);
  CHECK(*plain.distance_rms_m > 0.3);
  const Score score = open_loop_score(model, log);
  CHECK(score.position_rms_m->horizon_s == 10.0);
  CHECK(score.position_rms_m->value < 0.025);
  CHECK(*score.distance_rms_m < 0.025);
  CHECK_THAT(score.heading_rms_rad->value, WithinAbs(0.02, 0.008));
}

TEST_CASE("Each of the runs goes on by its own path when it is told where the robot is") {
  const DriveLog log = onto_the_rug();
  for (const auto& run : open_loop_runs(drifting_model({rug()}), log)) {
    for (std::size_t k = 1; k < run.size(); ++k) {
      const double moved_m = distance_between_m(run[k - 1].pose, run[k].pose);
      CHECK(moved_m < 0.21 * period_s);
      CHECK(run[k].free_for_s < 10.05);
    }
  }
}

TEST_CASE("Where no effect acts by place or heading, a free run is judged as it is") {
  const DriveLog log = onto_the_rug();
  AddedEffect drift;
  drift.setting = {"yaw_bias", "driving", {0.01}};
  const RobotModel model = drifting_model({drift});
  REQUIRE(open_loop_runs(model, log).size() == 1);
  CHECK(open_loop_score(model, log).position_rms_m->value ==
        score_run(free_run(model, log), log).position_rms_m->value);
}

TEST_CASE("With references at the ends alone a run is told where it begins, and there is one window") {
  DriveLog log = onto_the_rug();
  for (std::size_t k = 1; k + 1 < log.samples.size(); ++k) {
    log.samples[k].reference_x_m = log.samples[k].reference_y_m = log.samples[k].reference_theta_rad = {};
  }
  const RobotModel model = drifting_model({rug()});
  const Score plain = score_run(free_run(model, log), log);
  CHECK_THAT(open_loop_score(model, log).position_rms_m->value, WithinRel(plain.position_rms_m->value, 1e-9));
}

TEST_CASE("A wheel that is not round is judged at the angle that its counts tell, not where a run strayed") {
  const DriveLog log = on_rippling_wheels();
  const Score plain = score_run(free_run(hasty_model(), log), log);
  const Score score = open_loop_score(hasty_model(), log);
  CHECK(*plain.wheel_speed_rms_m_s > 0.04);
  CHECK(*score.wheel_speed_rms_m_s < 0.03);
  CHECK_THAT(*score.distance_rms_m, WithinAbs(*plain.distance_rms_m, 0.02));  // not told the way itself
}

TEST_CASE("Wheels that are not round and were not counted run free") {
  DriveLog log = on_rippling_wheels();
  log.metres_per_tick = {};
  for (auto& sample : log.samples) sample.ticks = {};
  CHECK(open_loop_runs(hasty_model(), log).size() == 1);
}
