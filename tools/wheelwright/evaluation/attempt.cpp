#include "tools/wheelwright/evaluation/attempt.hpp"

#include <algorithm>

#include "model/gap/fit/parallel_for.hpp"
#include "tools/wheelwright/evaluation/gap_models.hpp"
#include "tools/wheelwright/evaluation/robot_trial.hpp"

namespace wheelwright::tools {
namespace {

constexpr double charge_spread = 0.05;  // batteries are swapped and charged between attempts

using MaybeGapModels = tl::expected<GapModels, std::string>;

MaybeGapModels gap_models_of(const EvaluationPlan& plan, std::uint64_t number, const MaybeModel& arma) {
  if (plan.gap) return *plan.gap;
  if (!arma) return tl::make_unexpected(arma.error());
  const auto learned = learn_gap_models(plan, number, *arma, gap::serial_for);
  if (!learned) return tl::make_unexpected("the gap workflow: " + learned.error());
  return learned->models;
}

MaybeModel model_of(Knowledge knowledge, const CalibratedModels& calibrated,
                    const std::optional<MaybeGapModels>& gap) {
  switch (knowledge) {
    case Knowledge::fir:
      return calibrated.fir;
    case Knowledge::arma:
      return calibrated.arma;
    case Knowledge::refitted:
      return gap->map([](const GapModels& models) { return models.refitted; });
    case Knowledge::extended:
      return gap->map([](const GapModels& models) { return models.extended; });
  }
  return calibrated.fir;
}

void draw_wheels(simulation::SimulationConfig& robot, double mismatch, simulation::Noise& chance) {
  if (mismatch == 0.0) return;
  const double mean_m = 0.5 * (robot.left.diameter_m + robot.right.diameter_m);
  const double half = 0.5 * mismatch * chance.normal();
  robot.left.diameter_m = mean_m * (1.0 - half);
  robot.right.diameter_m = mean_m * (1.0 + half);
}

}  // namespace

RobotTrial trial_of(const EvaluationPlan& plan, std::uint64_t number, Purpose purpose) {
  simulation::Noise chance(simulation::Noise(plan.seed).bits() + number);
  simulation::SimulationConfig robot = plan.robot;
  robot.battery.charge = std::clamp(robot.battery.charge + charge_spread * chance.normal(), 0.05, 1.0);
  const std::uint64_t of_runs = chance.bits() + static_cast<std::uint64_t>(purpose);
  draw_wheels(robot, plan.wheel_mismatch, chance);
  return {robot, plan.limits, plan.link, simulation::Noise(of_runs)};
}

CalibratedModels calibrate(const EvaluationPlan& plan, std::uint64_t number) {
  RobotTrial trial = trial_of(plan, number, Purpose::calibrate);
  const CalibrationDrives drives = calibration_drives(plan.drives, plan.route.speed_m_s);
  const MaybeModel fir = trial.calibrate_response(drives.response);
  return {fir, fir ? trial.calibrate_arma(*fir, drives.random_drive) : fir};
}

AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number) {
  const CalibratedModels calibrated = plan.calibrated ? *plan.calibrated : calibrate(plan, number);
  std::optional<MaybeGapModels> gap;
  if (plan.gap || plan.learn_each) gap = gap_models_of(plan, number, calibrated.arma);
  RobotTrial trial = trial_of(plan, number, Purpose::drive);
  AttemptOutcome outcome;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates.at(i);
    if (is_by_gap_workflow(candidate.model) && !gap) continue;
    const MaybeModel model = model_of(candidate.model, calibrated, gap);
    outcome.at(i) = trial.drive(plan.route, candidate.source, model);
    outcome.at(i)->has_model = model.has_value();
    if (!model) continue;
    for (const AddedEffect& effect : model->effects) outcome.at(i)->effects.push_back(effect.setting.name);
  }
  return outcome;
}

}  // namespace wheelwright::tools
