#include "model/gap/candidates/screening.hpp"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr int periods = 2500;
constexpr double mismatch = 0.006;
constexpr double excess_m = 0.004;

// Arcs to both sides, tighter and wider ones.
WheelPair arcs(int period) {
  const int arc = period / 200;
  const double turn_m_s = 0.02 * (1 + arc % 3) * (arc % 2 == 0 ? 1.0 : -1.0);
  return {0.2 - turn_m_s, 0.2 + turn_m_s};
}

// A robot whose wheels are unlike and stand further apart than is known, seen by a camera.
GapRun watched_run(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> position_noise_m(0.0, 0.001);
  std::normal_distribution<double> heading_noise_rad(0.0, 0.005);
  const TrialModel robot = test::counted_robot();
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = robot.wheel_base_m;
  log.period_s = robot.period_s;
  log.metres_per_tick = test::counted_metres_per_tick;
  WheelPair way_m;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.3;
  for (int k = 0; k < periods; ++k) {
    DriveSample sample;
    sample.t_s = robot.period_s * k;
    sample.command_m_s = arcs(k + static_cast<int>(seed) * 37);
    sample.ticks = WheelTicks{std::llround(way_m.left / test::counted_metres_per_tick.left),
                              std::llround(way_m.right / test::counted_metres_per_tick.right)};
    sample.reference_x_m = x_m + position_noise_m(random);
    sample.reference_y_m = y_m + position_noise_m(random);
    sample.reference_theta_rad = heading_rad + heading_noise_rad(random);
    log.samples.push_back(sample);
    const WheelPair speed_m_s = simulation.step(sample.command_m_s).wheel_m_s;
    const double left_m = robot.period_s * speed_m_s.left;
    const double right_m = robot.period_s * speed_m_s.right;
    way_m.left += left_m;
    way_m.right += right_m;
    const double turn_rad = (right_m * (1.0 + mismatch / 2.0) - left_m * (1.0 - mismatch / 2.0)) /
                            (robot.wheel_base_m + excess_m);
    const double forward_m = 0.5 * (left_m + right_m);
    x_m += forward_m * std::cos(heading_rad + 0.5 * turn_rad);
    y_m += forward_m * std::sin(heading_rad + 0.5 * turn_rad);
    heading_rad += turn_rad;
  }
  GapRun run = make_gap_run(log, {}, robot.period_s);
  measure_motion(run);
  return run;
}

}  // namespace

TEST_CASE(
    "A second effect of the motion is screened at its worth, as counts hold the wheels beside the first") {
  const EffectInfo* track = find_effect("effective_track");
  const EffectInfo* scale = find_effect("wheel_scale_mismatch");
  FitProblem runs({watched_run(1), watched_run(2)},
                  {test::counted_metres_per_tick, test::counted_metres_per_tick}, serial_for);
  TrialModel both = test::counted_robot();
  both.effects = {{track, 0, {excess_m}}, {scale, 0, {mismatch}}};
  runs.set_noise(runs.noise_left_by(both));

  TrialModel first = test::counted_robot();
  first.effects = {{track, 0, {excess_m}}};
  const Fit without = runs.fit(first, 20);
  const Fit with = runs.fit(both, 20);
  const double worth_nats = 0.5 * (without.sum_squares - with.sum_squares);
  REQUIRE(worth_nats > 50.0);

  const std::vector<const EffectInfo*> candidates{scale};
  const Screening screening = screen(runs, without, candidates, serial_for);
  REQUIRE(!screening.best.empty());
  CHECK_THAT(screening.best.front().gain_nats, WithinRel(worth_nats, 0.1));
  CHECK_THAT(screening.best.front().start.parameters[0], WithinRel(mismatch, 0.1));
}
