// What a likelihood is beside a parabola: nothing where models are smooth, steps where commands are rounded.
#include <array>
#include <cmath>
#include <random>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/fit/likelihood_roughness.hpp"
#include "model/gap/runs/run.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

double swing_m_s(double t_s) {
  return 0.06 * std::sin(2.5 * t_s);
}

double jump_m_s(double t_s) {
  return 0.25 * std::sin(2.0 * std::floor(1.5 * t_s));
}

// Driven by such speeds, seen by counts and by a camera that errs by a millimetre.
Problem driven_by(double (*speed_m_s)(double t_s), const TrialModel& robot) {
  constexpr double metres_per_tick = 0.0004;
  std::mt19937 random(1);
  std::normal_distribution<double> errs(0.0, 1e-3);
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = robot.wheel_base_m;
  log.period_s = robot.period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  for (int k = 0; k < 3000; ++k) {
    DriveSample sample;
    sample.t_s = robot.period_s * k;
    const double left_m_s = speed_m_s(sample.t_s);
    const double right_m_s = 0.8 * speed_m_s(sample.t_s + 0.4);
    const Pose pose = simulation.observed_pose();
    sample.command_m_s = {left_m_s, right_m_s};
    sample.ticks = WheelTicks{std::llround(simulation.distance_m().left / metres_per_tick),
                              std::llround(simulation.distance_m().right / metres_per_tick)};
    sample.reference_x_m = pose.x_m + errs(random);
    sample.reference_y_m = pose.y_m + errs(random);
    sample.reference_theta_rad = pose.theta_rad + errs(random);
    log.samples.push_back(sample);
    simulation.step(sample.command_m_s);
  }
  GapRun run = make_gap_run(log, {}, robot.period_s);
  measure_motion(run);
  Problem problem({run}, {*log.metres_per_tick}, serial_for);
  problem.set_noise(problem.noise_left_by(robot));
  return problem;
}

TrialModel robot_with(const std::string& name, const std::vector<double>& parameters) {
  TrialModel model = first_guess({}, 0.02, 0.25, 0.06, 0.04);
  model.effects.push_back({find_effect(name), 0, parameters});
  return model;
}

double roughness_of(const TrialModel& robot) {
  const Problem problem = driven_by(swing_m_s, robot);
  const Fit fit = problem.fit(robot, 15);
  return likelihood_roughness(problem, fit, problem.jacobian(fit.model, fit.residuals));
}

}  // namespace

TEST_CASE("A smooth likelihood has no roughness") {
  CHECK(roughness_of(robot_with("direction_gain", {-0.05})) < 0.1);
  CHECK(roughness_of(robot_with("gain_curve", {0.1, 0.1})) < 0.1);
}

TEST_CASE("The likelihood of wheels that stick and slip is rough") {
  CHECK(roughness_of(robot_with("stiction", {0.02, 0.008, 0.03, 0.004})) > 0.5);
}

TEST_CASE("A fit with slip on the floor is as likely as the robot itself") {
  // Poses show how the wheels speed up, as slip depends on it.
  const TrialModel robot = robot_with("acceleration_slip", {0.45, 0.44});
  const Problem problem = driven_by(jump_m_s, robot);
  TrialModel start = robot_with("acceleration_slip", {0.3, 0.6});
  start.linear_part = first_guess({}, 0.02, 0.25, 0.1, 0.02).linear_part;
  const double of_robot = sum_squares_of(problem.residuals(robot));
  CHECK(problem.fit(start, 40).sum_squares < of_robot);
}
