#include "tools/wheelwright/evaluation/gap_models.hpp"

#include "model/gap/analysis.hpp"
#include "tools/wheelwright/evaluation/learning_drives.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::size_t recorded_drives = 6;

}  // namespace

tl::expected<LearnedGap, std::string> learn_gap_models(const EvaluationPlan& plan, std::uint64_t number,
                                                       const RobotModel& calibrated,
                                                       const gap::ParallelFor& parallel_for) {
  RobotTrial trial = trial_of(plan, number, Purpose::learn);
  simulation::Noise chance(simulation::Noise(plan.seed).bits() + number);
  const auto logs = learning_drives(recorded_drives, trial, calibrated, chance);
  if (!logs) return tl::make_unexpected(logs.error());

  const auto analysis = gap::analyse_gap(*logs, {}, {}, parallel_for, [](const std::string&, double) {});
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
