#include "tools/wheelwright/evaluation/attempt.hpp"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <tl/expected.hpp>

#include "daemon/virtual_run.hpp"
#include "drivers/simulation/noise.hpp"
#include "model/identification/arx_fit.hpp"
#include "tools/wheelwright/evaluation/random_drive.hpp"

namespace wheelwright::tools {
namespace {

using simulation::Noise;
using simulation::SimulatedRobot;
using simulation::SimulationConfig;

// PAPER.md, calibration C: no gain beyond.
constexpr std::size_t arma_order = 9;
constexpr double random_drive_s = 60.0;
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

// Puts robots down: each with the same charge and everything else by chance.
class Attempt {
 public:
  Attempt(const EvaluationPlan& plan, std::uint64_t number)
      : plan_(plan), chance_(Noise(plan.seed).bits() + number), config_(plan.robot) {
    config_.battery.charge = std::clamp(config_.battery.charge + charge_spread * chance_.normal(), 0.05, 1.0);
  }

  MaybeModel calibrate_response();
  MaybeModel calibrate_arma(const EncoderScale& scale);
  DriveOutcome drive(PoseSource source, const MaybeModel& model);

 private:
  SimulatedRobot put_down();

  const EvaluationPlan& plan_;
  Noise chance_;
  SimulationConfig config_;
};

SimulatedRobot Attempt::put_down() {
  SimulationConfig config = config_;
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

std::string reason_of(const daemon::VirtualRunResult& result) {
  if (result.refusal) return "calibration refused: " + result.refusal->reason;
  if (result.stop != StopReason::none) return "stopped: " + std::string(name_of(result.stop));
  return "did not end in time";
}

MaybeModel Attempt::calibrate_response() {
  SimulatedRobot robot = put_down();
  daemon::VirtualRunConfig run;
  run.limits = plan_.limits;
  run.link = plan_.link;
  run.mission.encoder_turn = EncoderTurnPlan{};
  run.mission.response = four_actions();
  const auto result = daemon::run_virtually(run, robot);
  if (!result.finished) return tl::make_unexpected(reason_of(result));
  RobotModel model;
  model.encoder_scale =
      EncoderScale{result.encoder_scale->metres_per_tick, result.encoder_scale->ticks_per_turn,
                   result.encoder_scale->relative_standard_error};
  model.core = result.response->model;
  return model;
}

MaybeModel Attempt::calibrate_arma(const EncoderScale& scale) {
  SimulatedRobot robot = put_down();
  const DriveLog log =
      drive_randomly(robot, plan_.link, plan_.limits, scale.metres_per_tick, random_drive_s, chance_.bits());
  ArxFitOptions options;
  options.order = arma_order;
  const auto fit = fit_arx(std::span(&log, 1), options);
  if (!fit) return tl::make_unexpected("calibration refused: " + fit.error().reason);
  RobotModel model;
  model.encoder_scale = scale;
  model.core = fit->model;
  return model;
}

DriveOutcome Attempt::drive(PoseSource source, const MaybeModel& model) {
  if (!model) return {std::nullopt, model.error()};
  SimulatedRobot robot = put_down();
  daemon::VirtualRunConfig run;
  run.limits = plan_.limits;
  run.link = plan_.link;
  run.mission.route = plan_.route;
  run.mission.pose_source = source;
  run.model = *model;
  const auto result = daemon::run_virtually(run, robot);
  if (!result.finished || !result.true_pose_at_route_start) return {std::nullopt, reason_of(result)};
  return {relative_to(*result.true_pose_at_route_start, result.true_poses.back()), {}};
}

}  // namespace

AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number) {
  Attempt attempt(plan, number);
  const MaybeModel fir = attempt.calibrate_response();
  const MaybeModel arma = fir ? attempt.calibrate_arma(*fir->encoder_scale) : fir;
  AttemptOutcome outcome;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Contender contender = contenders.at(i).contender;
    const PoseSource source = contender == Contender::odometry ? PoseSource::odometry : PoseSource::fir;
    outcome.at(i) = attempt.drive(source, contender == Contender::arma ? arma : fir);
  }
  return outcome;
}

}  // namespace wheelwright::tools
