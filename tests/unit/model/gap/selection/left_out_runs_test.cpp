#include "model/gap/selection/left_out_runs.hpp"

#include <cmath>
#include <random>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;

TrialModel with_mismatch(double mismatch) {
  TrialModel model = first_guess({}, period_s, 0.25, 0.06, 0.04);
  if (mismatch != 0.0) model.effects.push_back({find_effect("wheel_scale_mismatch"), 0, {mismatch}});
  return model;
}

// Straight on at some speed; poses err by a hundredth of a millimetre and of a milliradian.
GapRun straight(const TrialModel& robot, double speed_m_s, std::uint64_t seed) {
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  std::mt19937_64 random(seed);
  std::normal_distribution<double> error(0.0, 1e-5);
  DriveLog log;
  log.wheel_base_m = robot.wheel_base_m;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{1e-4, 1e-4};
  WheelPair way_m;
  for (int k = 0; k < 500; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = {speed_m_s, speed_m_s};
    sample.ticks = WheelTicks{std::llround(way_m.left / 1e-4), std::llround(way_m.right / 1e-4)};
    sample.reference_x_m = simulation.pose().x_m + error(random);
    sample.reference_y_m = simulation.pose().y_m + error(random);
    sample.reference_theta_rad = simulation.pose().theta_rad + error(random);
    log.samples.push_back(sample);
    const WheelPair speed = simulation.step(sample.command_m_s).wheel_m_s;
    way_m = {way_m.left + period_s * speed.left, way_m.right + period_s * speed.right};
  }
  GapRun run = make_gap_run(log, {}, period_s);
  measure_motion(run);
  return run;
}

double gain_of_mismatch(std::vector<GapRun> runs) {
  const std::size_t count = runs.size();
  FitProblem problem(std::move(runs), std::vector<WheelPair>(count, WheelPair{1e-4, 1e-4}), serial_for);
  NoiseModel noise = problem.noise();
  for (TravelNoise& channel : noise.channel) channel = {1e-4, 1e-3};
  problem.set_noise(noise);
  const Fit without = problem.fit(with_mismatch(0.0), 10);
  TrialModel start = without.model;
  start.effects = with_mismatch(0.01).effects;
  return left_out_runs_gain_nats(problem, without, problem.fit(start, 20), 0);
}

}  // namespace

TEST_CASE("What the other runs say of an effect predicts the run that was left out") {
  const TrialModel robot = with_mismatch(0.03);
  CHECK(gain_of_mismatch({straight(robot, 0.1, 1), straight(robot, 0.2, 2), straight(robot, 0.15, 3)}) >
        20.0);
}

TEST_CASE("An effect of which the other runs say something else gains nothing on a run") {
  CHECK(gain_of_mismatch({straight(with_mismatch(0.03), 0.2, 1), straight(with_mismatch(-0.03), 0.2, 2)}) <
        0.0);
}

TEST_CASE("One run alone leaves no other to predict it by") {
  CHECK(gain_of_mismatch({straight(with_mismatch(0.03), 0.2, 1)}) == 0.0);
}
