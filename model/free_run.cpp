#include "model/free_run.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "model/command_timeline.hpp"
#include "model/model_simulation.hpp"

namespace wheelwright {
namespace {

Pose start_pose(const DriveLog& log) {
  for (const auto& sample : log.samples) {
    if (!sample.reference_x_m || !sample.reference_y_m) continue;
    return {*sample.reference_x_m, *sample.reference_y_m, sample.reference_theta_rad.value_or(0.0)};
  }
  return {0.0, 0.0, log.samples.empty() ? 0.0 : log.samples.front().reference_theta_rad.value_or(0.0)};
}

// The newest voltage that was measured by row `row`.
double battery_at(const DriveLog& log, std::size_t row, double last_v) {
  return log.samples[row].battery_v.value_or(last_v);
}

Pose pose_at(const std::vector<PredictedMotion>& motion, double t_s) {
  const auto after = std::ranges::lower_bound(motion, t_s, {}, &PredictedMotion::t_s);
  if (after == motion.begin()) return motion.front().pose;
  if (after == motion.end()) return motion.back().pose;
  const PredictedMotion& before = *std::prev(after);
  const double share = (t_s - before.t_s) / (after->t_s - before.t_s);
  const Pose step = relative_to(before.pose, after->pose);
  return placed_at(before.pose, {share * step.x_m, share * step.y_m, share * step.theta_rad});
}

// Each row holds the pose that a late reference tells then.
void tell_late(std::vector<PredictedMotion>& motion, double late_s) {
  if (late_s == 0.0) return;
  const std::vector<PredictedMotion> in_time = motion;
  for (auto& row : motion) row.pose = pose_at(in_time, row.t_s - late_s);
}

}  // namespace

std::vector<PredictedMotion> free_run(const LinearModel& core, std::span<const EffectSetting> effects,
                                      const DriveLog& log, std::span<const std::size_t> told_rows) {
  std::vector<PredictedMotion> motion;
  if (log.samples.empty()) return motion;
  motion.reserve(log.samples.size());
  const CommandTimeline timeline(log);
  const double t0 = log.samples.front().t_s;
  const double period = core.period_s;
  ModelSimulation simulation(core, effects);
  simulation.reset(simulation.axle_of(start_pose(log)), log.rolled_before_m);
  double battery_v = battery_at(log, 0, std::numeric_limits<double>::quiet_NaN());

  motion.push_back({t0, {}, {}, {}, simulation.observed_pose(), 0.0});
  double told_s = t0;
  auto told = told_rows.begin();
  if (told != told_rows.end() && *told == 0) ++told;
  Pose axle = simulation.pose();
  std::size_t row = 1;
  for (std::size_t cell = 0; row < log.samples.size(); ++cell) {
    const double from = t0 + period * static_cast<double>(cell);
    const double to = t0 + period * static_cast<double>(cell + 1);
    const WheelPair before = simulation.distance_m();
    const auto& now = simulation.step(timeline.mean_m_s(from, to), battery_v);
    // Times are printed with microseconds, so a row on the grid may lie that much behind it.
    const double end_of_cell = to + 1e-4 * period;
    for (; row < log.samples.size() && log.samples[row].t_s <= end_of_cell; ++row) {
      const double t = log.samples[row].t_s;
      if (told != told_rows.end() && *told == row) {
        const double ago_s = to - t + log.references_late_s;
        simulation.set_pose(
            move_along_arc(simulation.axle_of(log.samples[row].reference_pose().value()), now.twist, ago_s));
        told_s = t;
        ++told;
      }
      motion.push_back({t,
                        now.floor_m_s,
                        now.twist,
                        {before.left - log.rolled_before_m.left + now.wheel_m_s.left * (t - from),
                         before.right - log.rolled_before_m.right + now.wheel_m_s.right * (t - from)},
                        simulation.observed(move_along_arc(axle, now.twist, t - from)),
                        t - told_s});
      battery_v = battery_at(log, row, battery_v);
    }
    axle = move_along_arc(axle, now.twist, period);
  }
  tell_late(motion, log.references_late_s);
  return motion;
}

std::vector<PredictedMotion> free_run(const LinearModel& model, const DriveLog& log) {
  return free_run(model, {}, log);
}

std::vector<PredictedMotion> free_run(const RobotModel& model, const DriveLog& log) {
  return free_run(model.core, effect_settings(model), log);
}

}  // namespace wheelwright
