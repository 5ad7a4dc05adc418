#include "tools/wheelwright/evaluation/gap_models.hpp"

#include <limits>

#include "model/gap/analysis.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"
#include "tools/wheelwright/evaluation/learning_drives.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::size_t drives = 6;
constexpr std::uint64_t before_all = std::numeric_limits<std::uint64_t>::max();  // number of no attempt

}  // namespace

tl::expected<LearnedGap, std::string> learn_gap_models(const EvaluationPlan& plan) {
  RobotTrial calibration = trial_of(plan, before_all, Purpose::calibrate);
  MaybeModel model = calibration.calibrate_response();
  if (model) model = calibration.calibrate_arma(*model);
  if (!model) return tl::make_unexpected(model.error());

  RobotTrial trial = trial_of(plan, before_all, Purpose::drive);
  simulation::Noise chance(plan.seed);
  const auto logs = learning_drives(drives, trial, *model, chance);
  if (!logs) return tl::make_unexpected(logs.error());

  const auto analysis = gap::analyse_gap(*logs, {}, {}, parallel_for(), [](const std::string&, double) {});
  if (!analysis) return tl::make_unexpected(analysis.error().reason);
  LearnedGap learned;
  learned.models = {analysis->before, analysis->after};
  if (learned.models.extended.linear_part.left.from_left.empty())
    return tl::make_unexpected(analysis->summary);
  learned.found = std::string(gap::verdict_name(analysis->verdict));
  for (const auto& found : analysis->found) learned.found += " " + found.setting.name;
  return learned;
}

}  // namespace wheelwright::tools
