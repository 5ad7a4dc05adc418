#include "model/prediction/open_loop_runs.hpp"

#include <algorithm>
#include <cstddef>

#include "model/effects/library/effect_library.hpp"
#include "model/prediction/segments.hpp"

namespace wheelwright {
namespace {

bool any_acts(const std::vector<EffectSetting>& effects, bool EffectInfo::*by) {
  return std::ranges::any_of(effects, [by](const EffectSetting& setting) {
    const EffectInfo* info = find_effect(setting.name);
    return info != nullptr && info->*by;
  });
}

// The first rows from `after_first_s` on that tell, and a horizon after one another.
template <typename Tells>
std::vector<std::size_t> reset_rows(const DriveLog& log, double after_first_s, Tells tells) {
  std::vector<std::size_t> rows;
  double next_s = 0.0;
  bool any = false;
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const DriveSample& sample = log.samples[row];
    if (!tells(sample)) continue;
    if (!any) next_s = sample.t_s + after_first_s;
    any = true;
    if (sample.t_s < next_s) continue;
    rows.push_back(row);
    while (next_s <= sample.t_s) next_s += longest_horizon_s;
  }
  return rows;
}

}  // namespace

bool is_reset_to_measured_pose(const RobotModel& model, const DriveLog& log) {
  const auto effects = effect_settings(model);
  return any_acts(effects, &EffectInfo::by_pose) ||
         (log.metres_per_tick && any_acts(effects, &EffectInfo::by_wheel_angle));
}

std::vector<std::vector<PredictedMotion>> open_loop_runs(const RobotModel& model, const DriveLog& log) {
  const auto effects = effect_settings(model);
  if (!is_reset_to_measured_pose(model, log)) return {free_run(model.linear_part, effects, log)};
  const bool by_pose = any_acts(effects, &EffectInfo::by_pose);
  const bool by_place = by_pose && log.has_reference_positions();
  const auto tells = [=](const DriveSample& sample) {
    if (by_place) return sample.reference_pose().has_value();
    return by_pose ? sample.reference_theta_rad.has_value() : sample.ticks.has_value();
  };
  std::vector<std::vector<PredictedMotion>> runs;
  for (double after_s = 0.0; after_s < longest_horizon_s; after_s += between_windows_s) {
    runs.push_back(free_run(model.linear_part, effects, log, reset_rows(log, after_s, tells)));
  }
  return runs;
}

void add_open_loop(const RobotModel& model, const DriveLog& log, ScoreSums& sums) {
  const auto runs = open_loop_runs(model, log);
  const std::vector<Prediction> predictions(runs.begin(), runs.end());
  add_segments(predictions, log, model.linear_part.period_s, sums);
}

}  // namespace wheelwright
