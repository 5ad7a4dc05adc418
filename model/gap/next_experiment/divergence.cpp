#include "model/gap/next_experiment/divergence.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

// Counts of a made-up drive are not to add noise of their own.
constexpr double fine_m_per_tick = 1e-7;

}  // namespace

Sensors sensors_of(const GapRun& run) {
  Sensors sensors;
  sensors.counts = run.has_counts;
  const std::size_t count = run.references.size();
  if (count >= 2) {
    const std::size_t span = run.references.back().at.period - run.references.front().at.period;
    sensors.reference_every = std::max<std::size_t>(1, span / (count - 1));
  }
  return sensors;
}

DriveLog commands_of(const Manoeuvre& manoeuvre, const TrialModel& model) {
  DriveLog log;
  log.name = manoeuvre.name;
  log.wheel_base_m = model.wheel_base_m;
  log.period_s = model.period_s;
  for (std::size_t k = 0; k < manoeuvre.commands_m_s.size(); ++k) {
    DriveSample sample;
    sample.t_s = model.period_s * static_cast<double>(k);
    sample.command_m_s = manoeuvre.commands_m_s[k];
    log.samples.push_back(sample);
  }
  return log;
}

DriveLog driven_by(const TrialModel& truth, DriveLog log, const Sensors& sensors) {
  ModelSimulation simulation = truth.simulation();
  simulation.reset({});
  if (sensors.counts) log.metres_per_tick = WheelPair{fine_m_per_tick, fine_m_per_tick};
  const std::size_t last = log.samples.size() - 1;
  const std::size_t every = std::min(sensors.reference_every, last);
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    DriveSample& sample = log.samples[k];
    if (sensors.counts) {
      const WheelPair& rolled = simulation.distance_m();
      sample.ticks = WheelTicks{std::llround(rolled.left / fine_m_per_tick),
                                std::llround(rolled.right / fine_m_per_tick)};
    }
    if (every > 0 && (k % every == 0 || k == last)) {
      const Pose pose = simulation.observed_pose();
      sample.reference_x_m = pose.x_m;
      sample.reference_y_m = pose.y_m;
      sample.reference_theta_rad = pose.theta_rad;
    }
    simulation.step(sample.command_m_s);
  }
  return log;
}

bool stays_inside(const TrialModel& model, const DriveLog& log, double radius_m) {
  ModelSimulation simulation = model.simulation();
  simulation.reset({});
  for (const auto& sample : log.samples) {
    simulation.step(sample.command_m_s);
    if (std::hypot(simulation.pose().x_m, simulation.pose().y_m) > radius_m) return false;
  }
  return true;
}

double divergence(const Hypothesis& truth, const Hypothesis& other, const DriveLog& commands,
                  const Sensors& sensors, const NoiseModel& noise) {
  const DriveLog log = driven_by(truth.model, commands, sensors);
  GapRun run = make_gap_run(log, {}, truth.model.period_s);
  measure_motion(run);
  FitProblem drive({std::move(run)}, {log.metres_per_tick.value_or(WheelPair{})}, serial_for);
  drive.set_noise(noise);
  const std::vector<double> apart = drive.residuals(other.model);
  const Eigen::MatrixXd columns = drive.jacobian(other.model, apart);
  const Eigen::Map<const Eigen::VectorXd> residual(apart.data(), static_cast<Eigen::Index>(apart.size()));
  Eigen::MatrixXd curvature = columns.transpose() * columns + other.information;
  curvature.diagonal().array() += 1e-9 * (1.0 + curvature.diagonal().maxCoeff());
  const Eigen::VectorXd gradient = columns.transpose() * residual;
  return std::max(0.0, 0.5 * (residual.squaredNorm() - gradient.dot(solve_symmetric(curvature, gradient))));
}

}  // namespace wheelwright::gap
