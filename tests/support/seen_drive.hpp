// Drives of a robot whose model is known, seen by a camera that errs by a millimetre and a milliradian, and
// by counts where asked for.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/runs/run.hpp"

namespace wheelwright::test {

enum class Counts { none, of_wheels };

inline gap::TrialModel robot_with(const std::string& effect, const std::vector<double>& parameters,
                                  const gap::LinearPartShape& shape = {}) {
  gap::TrialModel model = gap::first_guess(shape, 0.02, 0.25, 0.06, 0.04);
  model.effects.push_back({find_effect(effect), 0, parameters});
  return model;
}

// A problem of one run, under the noise that is likeliest for the robot itself.
inline gap::FitProblem seen_drive(const gap::TrialModel& robot, int periods,
                                  const std::function<WheelPair(double time_s)>& command_m_s, Counts counts,
                                  unsigned seed_of_errors = 1) {
  constexpr double metres_per_tick = 0.0004;
  std::mt19937 random(seed_of_errors);
  std::normal_distribution<double> errs(0.0, 1e-3);
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = robot.wheel_base_m;
  log.period_s = robot.period_s;
  if (counts == Counts::of_wheels) log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  for (int k = 0; k < periods; ++k) {
    const Pose pose = simulation.observed_pose();
    DriveSample sample;
    sample.t_s = robot.period_s * k;
    sample.command_m_s = command_m_s(sample.t_s);
    if (counts == Counts::of_wheels) {
      sample.ticks = WheelTicks{std::llround(simulation.distance_m().left / metres_per_tick),
                                std::llround(simulation.distance_m().right / metres_per_tick)};
    }
    sample.reference_x_m = pose.x_m + errs(random);
    sample.reference_y_m = pose.y_m + errs(random);
    sample.reference_theta_rad = pose.theta_rad + errs(random);
    log.samples.push_back(sample);
    simulation.step(sample.command_m_s);
  }
  gap::GapRun run = gap::make_gap_run(log, {}, robot.period_s);
  gap::measure_motion(run);
  gap::FitProblem problem({run}, {log.metres_per_tick.value_or(WheelPair{})}, gap::serial_for);
  problem.set_noise(problem.noise_left_by(robot));
  return problem;
}

}  // namespace wheelwright::test
