#include "model/prediction/free_run.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "model/log/command_timeline.hpp"
#include "model/simulation/model_simulation.hpp"

namespace wheelwright {
namespace {

Pose start_pose(const DriveLog& log) {
  for (const auto& sample : log.samples) {
    if (!sample.reference_x_m || !sample.reference_y_m) continue;
    return {*sample.reference_x_m, *sample.reference_y_m, sample.reference_theta_rad.value_or(0.0)};
  }
  const auto told = std::ranges::find_if(
      log.samples, [](const DriveSample& sample) { return sample.reference_theta_rad.has_value(); });
  return {0.0, 0.0, told == log.samples.end() ? 0.0 : *told->reference_theta_rad};
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
  const Pose step = between(before.pose, after->pose);
  return compose(before.pose, {share * step.x_m, share * step.y_m, share * step.theta_rad});
}

// Each row holds the pose that a late reference, or one that smooths, shows then.
void show_late(std::vector<PredictedMotion>& motion, const DriveLog& log) {
  if (log.references_late_s == 0.0 && log.reference_response.is_immediate()) return;
  const std::vector<PredictedMotion> in_time = motion;
  for (auto& row : motion) {
    row.pose = shown_at(log.reference_response, row.t_s - log.references_late_s,
                        [&](double t_s) { return pose_at(in_time, t_s); });
  }
}

// How far the wheels have rolled by their counts, from where a run of the model stood when they began.
class CountedWay {
 public:
  explicit CountedWay(const DriveLog& log) : metres_per_tick_(log.metres_per_tick.value_or(WheelPair{})) {}

  // The way at a row; to be called with each in turn. Where there are no counts the model's own has to do.
  WheelPair at(const DriveSample& sample, const WheelPair& by_model_m) {
    if (!sample.ticks) return by_model_m;
    const WheelPair counted_m{static_cast<double>(sample.ticks->left) * metres_per_tick_.left,
                              static_cast<double>(sample.ticks->right) * metres_per_tick_.right};
    if (!began_ || sample.counter_reset) {
      ahead_m_ = {by_model_m.left - counted_m.left, by_model_m.right - counted_m.right};
    }
    began_ = true;
    return {counted_m.left + ahead_m_.left, counted_m.right + ahead_m_.right};
  }

 private:
  WheelPair metres_per_tick_;
  WheelPair ahead_m_;  // of the counts
  bool began_ = false;
};

WheelPair later(const WheelPair& way_m, const WheelPair& speed_m_s, double by_s) {
  return {way_m.left + speed_m_s.left * by_s, way_m.right + speed_m_s.right * by_s};
}

// Tells what was measured `ago_s` before where the simulation stands.
void tell(ModelSimulation& simulation, const DriveSample& sample, const WheelPair& rolled_m, double late_s,
          double ago_s) {
  const auto& motion = simulation.motion();
  if (sample.reference_theta_rad) {
    const Pose own = simulation.observed_pose();
    const Pose reference =
        sample.reference_pose().value_or(Pose{own.x_m, own.y_m, *sample.reference_theta_rad});
    simulation.set_pose(move_along_arc(simulation.axle_of(reference), motion.twist, ago_s + late_s));
  }
  simulation.set_distance_m(later(rolled_m, motion.wheel_m_s, ago_s));
}

}  // namespace

std::vector<PredictedMotion> free_run(const LinearModel& linear_part, std::span<const EffectSetting> effects,
                                      const DriveLog& log, std::span<const std::size_t> reset_rows) {
  std::vector<PredictedMotion> motion;
  if (log.samples.empty()) return motion;
  motion.reserve(log.samples.size());
  const CommandTimeline timeline(log);
  const double t0 = log.samples.front().t_s;
  const double period = linear_part.period_s;
  ModelSimulation simulation(linear_part, effects);
  simulation.reset(simulation.axle_of(start_pose(log)), log.initial_travel_m);
  double battery_v = battery_at(log, 0, std::numeric_limits<double>::quiet_NaN());

  motion.push_back({t0, {}, {}, {}, simulation.observed_pose(), 0.0});
  double told_s = t0;
  auto told = reset_rows.begin();
  if (told != reset_rows.end() && *told == 0) ++told;
  Pose axle = simulation.pose();
  WheelPair travelled_m;
  CountedWay counted(log);
  counted.at(log.samples.front(), simulation.distance_m());
  std::size_t row = 1;
  for (std::size_t cell = 0; row < log.samples.size(); ++cell) {
    const double from = t0 + period * static_cast<double>(cell);
    const double to = t0 + period * static_cast<double>(cell + 1);
    const auto& now = simulation.step(timeline.mean_m_s(from, to), battery_v);
    // Times are printed with microseconds, so a row on the grid may lie that much behind it.
    const double end_of_cell = to + 1e-4 * period;
    for (; row < log.samples.size() && log.samples[row].t_s <= end_of_cell; ++row) {
      const DriveSample& sample = log.samples[row];
      const double t = sample.t_s;
      const WheelPair rolled_m = counted.at(sample, later(simulation.distance_m(), now.wheel_m_s, t - to));
      if (told != reset_rows.end() && *told == row) {
        tell(simulation, sample, rolled_m, log.references_late_s + log.reference_response.position.mean_s(),
             to - t);
        told_s = t;
        ++told;
      }
      motion.push_back({t, now.floor_m_s, now.twist, later(travelled_m, now.wheel_m_s, t - from),
                        simulation.observed(move_along_arc(axle, now.twist, t - from)), t - told_s});
      battery_v = battery_at(log, row, battery_v);
    }
    axle = move_along_arc(axle, now.twist, period);
    travelled_m = later(travelled_m, now.wheel_m_s, period);
  }
  show_late(motion, log);
  return motion;
}

std::vector<PredictedMotion> free_run(const LinearModel& model, const DriveLog& log) {
  return free_run(model, {}, log);
}

std::vector<PredictedMotion> free_run(const RobotModel& model, const DriveLog& log) {
  return free_run(model.linear_part, effect_settings(model), log);
}

}  // namespace wheelwright
