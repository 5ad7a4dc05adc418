#include "tools/wheelwright/evaluation/robot_trial.hpp"

#include <Eigen/Core>
#include <chrono>
#include <numbers>

#include "model/log/sign_corrected_travel.hpp"
#include "model/statistics/dense_solve.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"

namespace wheelwright::tools {
namespace {

using simulation::SimulatedRobot;
using simulation::SimulationConfig;

// A random drive whose fit is refused is driven again, with other commands, up to this number of drives.
constexpr int max_random_drives = 3;

std::string reason_of(const daemon::VirtualRunResult& result) {
  if (result.refusal) return "calibration refused: " + result.refusal->reason;
  if (result.stop != StopReason::none) return "stopped: " + std::string(name_of(result.stop));
  return "did not end in time";
}

bool is_driving(const SensorFrame& frame) {
  const Activity activity = frame.command.activity;
  return activity == Activity::route || activity == Activity::random_drive ||
         activity == Activity::commanded_drive;
}

std::optional<EndEstimate> end_estimate(const PoseRecord& last, PoseSource source) {
  if (is_sensorless(source)) return EndEstimate{last.predicted, last.predicted_covariance};
  if (source == PoseSource::hybrid && last.hybrid)
    return EndEstimate{last.hybrid->pose, last.hybrid->covariance};
  return std::nullopt;
}

}  // namespace

std::optional<bool> inside_ellipse95(const DriveOutcome& outcome) {
  if (!outcome.end || !outcome.estimate) return std::nullopt;
  const EndEstimate& estimate = *outcome.estimate;
  const Eigen::Vector2d off(outcome.end->x_m - estimate.pose.x_m, outcome.end->y_m - estimate.pose.y_m);
  const Eigen::Matrix2d covariance = estimate.covariance.topLeftCorner<2, 2>();
  return off.dot(solve_symmetric(covariance, off)) <= chi_square95_of_two;
}

RobotTrial::RobotTrial(const SimulationConfig& robot, const RobotLimits& limits,
                       const roomba::LinkConfig& link, simulation::Noise chance)
    : robot_(robot), limits_(limits), link_(link), chance_(chance) {}

SimulatedRobot RobotTrial::put_down(const simulation::RoomConfig& room) {
  SimulationConfig config = robot_;
  config.room = room;
  config.seed = chance_.bits();
  const auto any_angle = [&] { return 2.0 * std::numbers::pi * chance_.uniform(); };
  config.left.eccentricity_phase_rad = any_angle();
  config.right.eccentricity_phase_rad = any_angle();
  const auto any_count = [&] { return static_cast<int>(chance_.bits() % 65536U); };
  config.encoder.start_count_left = any_count();
  config.encoder.start_count_right = any_count();
  SimulatedRobot robot(config);
  // Its firmware's clock and the host's have nothing to do with each other.
  robot.advance(std::chrono::microseconds(static_cast<std::int64_t>(1e6 * chance_.uniform())));
  return robot;
}

simulation::RoomConfig RobotTrial::without_walls() const {
  simulation::RoomConfig open = robot_.room;
  open.walls.clear();
  open.obstacles.clear();
  return open;
}

daemon::VirtualRunConfig RobotTrial::run_of(const Mission& mission) const {
  daemon::VirtualRunConfig run;
  run.mission = mission;
  run.limits = limits_;
  run.link = link_;
  return run;
}

MaybeModel RobotTrial::calibrate_response(const ResponsePlan& plan) {
  Mission mission;
  mission.encoder_turn = EncoderTurnPlan{};
  mission.response = plan;
  SimulatedRobot robot = put_down(robot_.room);
  const auto result = daemon::run_virtually(run_of(mission), robot);
  if (!result.finished) return tl::make_unexpected(reason_of(result));
  return *result.model;
}

MaybeModel RobotTrial::calibrate_arma(const RobotModel& response, const RandomDrivePlan& plan) {
  // Out in the open, where there is room for a random drive.
  const simulation::RoomConfig open = without_walls();
  std::string refusal;
  for (int drives = 0; drives < max_random_drives; ++drives) {
    Mission mission;
    mission.random_drive = plan;
    mission.random_drive->seed = chance_.bits();
    daemon::VirtualRunConfig run = run_of(mission);
    run.model = response;
    SimulatedRobot robot = put_down(open);
    const auto result = daemon::run_virtually(run, robot);
    if (result.finished) {
      RobotModel model = *result.model;
      model.encoder_scale = response.encoder_scale;
      return model;
    }
    refusal = reason_of(result);
  }
  return tl::make_unexpected(refusal);
}

DriveOutcome RobotTrial::drive(const Route& route, PoseSource source, const MaybeModel& model) {
  if (!model) return {std::nullopt, model.error()};
  Mission mission;
  mission.route = route;
  mission.pose_source = source;
  daemon::VirtualRunConfig run = run_of(mission);
  run.model = *model;
  SimulatedRobot robot = put_down(robot_.room);
  const auto result = daemon::run_virtually(run, robot);
  if (!result.finished || !result.true_pose_at_route_start) return {std::nullopt, reason_of(result)};
  return {between(*result.true_pose_at_route_start, result.true_poses.back()),
          {},
          end_estimate(result.records.back(), source)};
}

tl::expected<DriveLog, std::string> RobotTrial::record(const Mission& mission, const RobotModel& model,
                                                       const ReferenceNoise& noise) {
  daemon::VirtualRunConfig run = run_of(mission);
  run.model = model;
  SimulatedRobot robot = put_down(without_walls());
  const auto result = daemon::run_virtually(run, robot);
  // What becomes of the fit after a random drive does not matter: the drive is what is wanted.
  if (!result.finished && !result.refusal) return tl::make_unexpected(reason_of(result));

  DriveLog log;
  log.wheel_base_m = limits_.wheel_base_m;
  log.period_s = limits_.period_s;
  log.metres_per_tick = model.encoder_scale ? model.encoder_scale->metres_per_tick : limits_.metres_per_tick;
  std::vector<WheelTicks> counted;
  std::optional<Pose> origin;
  std::int64_t first_tick = 0;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const SensorFrame& frame = result.frames[i];
    if (!is_driving(frame) || (!origin && !frame.valid)) continue;
    if (!origin) {
      origin = result.true_poses[i];
      first_tick = frame.tick;
    }
    DriveSample sample;
    sample.t_s = static_cast<double>(frame.tick - first_tick) * limits_.period_s;
    sample.command_m_s = frame.command.speed_m_s;
    if (frame.valid) {
      const Pose pose = between(*origin, result.true_poses[i]);
      sample.ticks = frame.ticks;
      sample.battery_v = frame.battery_v;
      sample.reference_x_m = pose.x_m + noise.position_m * chance_.normal();
      sample.reference_y_m = pose.y_m + noise.position_m * chance_.normal();
      sample.reference_theta_rad = pose.theta_rad + noise.heading_rad * chance_.normal();
    }
    log.samples.push_back(sample);
    counted.push_back(frame.counted_ticks);
  }
  if (log.samples.empty()) return tl::make_unexpected(std::string("the robot did not drive"));
  settle_travel(std::span(&log, 1), std::span(&counted, 1));
  return log;
}

}  // namespace wheelwright::tools
