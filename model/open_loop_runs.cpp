#include "model/open_loop_runs.hpp"

#include <algorithm>
#include <cstddef>

#include "model/effect_library.hpp"
#include "model/identification/known_stretches.hpp"

namespace wheelwright {
namespace {

bool acts_by_pose(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  return info != nullptr && info->by_pose;
}

// The first references from `after_first_s` on, and a horizon after one another.
std::vector<std::size_t> told_rows(const DriveLog& log, double after_first_s) {
  std::vector<std::size_t> rows;
  double next_s = 0.0;
  bool any = false;
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const DriveSample& sample = log.samples[row];
    if (!sample.reference_pose()) continue;
    if (!any) next_s = sample.t_s + after_first_s;
    any = true;
    if (sample.t_s < next_s) continue;
    rows.push_back(row);
    while (next_s <= sample.t_s) next_s += longest_horizon_s;
  }
  return rows;
}

}  // namespace

std::vector<std::vector<PredictedMotion>> open_loop_runs(const RobotModel& model, const DriveLog& log) {
  const auto effects = effect_settings(model);
  if (std::ranges::none_of(effects, acts_by_pose)) return {free_run(model.core, effects, log)};
  std::vector<std::vector<PredictedMotion>> runs;
  for (double after_s = 0.0; after_s < longest_horizon_s; after_s += between_windows_s) {
    runs.push_back(free_run(model.core, effects, log, told_rows(log, after_s)));
  }
  return runs;
}

void add_open_loop(const RobotModel& model, const DriveLog& log, ScoreSums& sums) {
  const auto runs = open_loop_runs(model, log);
  const std::vector<Prediction> predictions(runs.begin(), runs.end());
  add_known_stretches(predictions, log, model.core.period_s, sums);
}

}  // namespace wheelwright
