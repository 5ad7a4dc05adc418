#include "tools/wheelwright/evaluation/attempt.hpp"

#include <algorithm>

#include "tools/wheelwright/evaluation/robot_trial.hpp"

namespace wheelwright::tools {
namespace {

constexpr double charge_spread = 0.05;  // batteries are swapped and charged between attempts

MaybeModel model_of(Knowledge knowledge, const MaybeModel& fir, const MaybeModel& arma,
                    const EvaluationPlan& plan) {
  switch (knowledge) {
    case Knowledge::fir:
      return fir;
    case Knowledge::arma:
      return arma;
    case Knowledge::refitted:
      return plan.gap->refitted;
    case Knowledge::extended:
      return plan.gap->extended;
  }
  return fir;
}

}  // namespace

RobotTrial trial_of(const EvaluationPlan& plan, std::uint64_t number, Purpose purpose) {
  simulation::Noise chance(simulation::Noise(plan.seed).bits() + number);
  simulation::SimulationConfig robot = plan.robot;
  robot.battery.charge = std::clamp(robot.battery.charge + charge_spread * chance.normal(), 0.05, 1.0);
  return {robot, plan.limits, plan.link,
          simulation::Noise(chance.bits() + static_cast<std::uint64_t>(purpose))};
}

AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number) {
  RobotTrial calibration = trial_of(plan, plan.calibrate == Calibrate::once ? 0 : number, Purpose::calibrate);
  const MaybeModel fir = calibration.calibrate_response();
  const MaybeModel arma = fir ? calibration.calibrate_arma(*fir) : fir;
  RobotTrial trial = trial_of(plan, number, Purpose::drive);
  AttemptOutcome outcome;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates.at(i);
    if (is_by_gap_workflow(candidate.model) && !plan.gap) continue;
    outcome.at(i) = trial.drive(plan.route, candidate.source, model_of(candidate.model, fir, arma, plan));
  }
  return outcome;
}

}  // namespace wheelwright::tools
