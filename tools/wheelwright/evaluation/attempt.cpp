#include "tools/wheelwright/evaluation/attempt.hpp"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <tl/expected.hpp>

#include "daemon/virtual_run.hpp"
#include "drivers/simulation/noise.hpp"

namespace wheelwright::tools {
namespace {

using simulation::Noise;
using simulation::SimulatedRobot;
using simulation::SimulationConfig;

// A random drive whose fit is refused is driven again, with other commands, up to this number of drives.
constexpr int most_random_drives = 3;
constexpr double charge_spread = 0.05;  // batteries are swapped and charged between attempts

// PAPER.md, calibration B, twice: one pass has too few samples for the responses of both wheels.
ResponsePlan four_actions() {
  ResponsePlan plan;
  plan.repetitions = 2;
  plan.speed_spread = 0.0;
  plan.alternate_direction = false;
  plan.on_s = 1.0;
  return plan;
}

using MaybeModel = tl::expected<RobotModel, std::string>;

// What it is done for, since calibrating and driving do not share their luck.
enum class Purpose : std::uint8_t { calibrate, drive };

// Puts robots down: each with the same charge and everything else by chance.
class Attempt {
 public:
  Attempt(const EvaluationPlan& plan, std::uint64_t number, Purpose purpose)
      : plan_(plan), chance_(Noise(plan.seed).bits() + number), config_(plan.robot) {
    config_.battery.charge = std::clamp(config_.battery.charge + charge_spread * chance_.normal(), 0.05, 1.0);
    chance_ = Noise(chance_.bits() + static_cast<std::uint64_t>(purpose));
  }

  MaybeModel calibrate_response();
  MaybeModel calibrate_arma(const RobotModel& response);
  DriveOutcome drive(PoseSource source, const MaybeModel& model);

 private:
  SimulatedRobot put_down(const simulation::RoomConfig& room);
  daemon::VirtualRunConfig run_of(const Mission& mission) const;

  const EvaluationPlan& plan_;
  Noise chance_;
  SimulationConfig config_;
};

SimulatedRobot Attempt::put_down(const simulation::RoomConfig& room) {
  SimulationConfig config = config_;
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

daemon::VirtualRunConfig Attempt::run_of(const Mission& mission) const {
  daemon::VirtualRunConfig run;
  run.mission = mission;
  run.limits = plan_.limits;
  run.link = plan_.link;
  return run;
}

std::string reason_of(const daemon::VirtualRunResult& result) {
  if (result.refusal) return "calibration refused: " + result.refusal->reason;
  if (result.stop != StopReason::none) return "stopped: " + std::string(name_of(result.stop));
  return "did not end in time";
}

MaybeModel Attempt::calibrate_response() {
  Mission mission;
  mission.encoder_turn = EncoderTurnPlan{};
  mission.response = four_actions();
  SimulatedRobot robot = put_down(config_.room);
  const auto result = daemon::run_virtually(run_of(mission), robot);
  if (!result.finished) return tl::make_unexpected(reason_of(result));
  return *result.model;
}

// By the response model and its encoder scale the robot knows where it is, and so stays on its spot.
MaybeModel Attempt::calibrate_arma(const RobotModel& response) {
  // The same floor, but out in the open, where there is room for a random drive.
  simulation::RoomConfig open = config_.room;
  open.walls.clear();
  open.obstacles.clear();
  std::string refusal;
  for (int drives = 0; drives < most_random_drives; ++drives) {
    Mission mission;
    mission.random_drive = RandomDrivePlan{};
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

DriveOutcome Attempt::drive(PoseSource source, const MaybeModel& model) {
  if (!model) return {std::nullopt, model.error()};
  Mission mission;
  mission.route = plan_.route;
  mission.pose_source = source;
  daemon::VirtualRunConfig run = run_of(mission);
  run.model = *model;
  SimulatedRobot robot = put_down(config_.room);
  const auto result = daemon::run_virtually(run, robot);
  if (!result.finished || !result.true_pose_at_route_start) return {std::nullopt, reason_of(result)};
  return {relative_to(*result.true_pose_at_route_start, result.true_poses.back()), {}};
}

}  // namespace

AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number) {
  Attempt calibration(plan, plan.calibrate == Calibrate::once ? 0 : number, Purpose::calibrate);
  const MaybeModel fir = calibration.calibrate_response();
  const MaybeModel arma = fir ? calibration.calibrate_arma(*fir) : fir;
  Attempt attempt(plan, number, Purpose::drive);
  AttemptOutcome outcome;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Contender& contender = contenders.at(i);
    outcome.at(i) = attempt.drive(contender.source, contender.model == ModelType::arma ? arma : fir);
  }
  return outcome;
}

}  // namespace wheelwright::tools
