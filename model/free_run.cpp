#include "model/free_run.hpp"

#include <cmath>

#include "model/command_timeline.hpp"

namespace wheelwright {
namespace {

Pose start_pose(const DriveLog& log) {
  for (const auto& sample : log.samples) {
    if (!sample.reference_x_m || !sample.reference_y_m) continue;
    return {*sample.reference_x_m, *sample.reference_y_m, sample.reference_theta_rad.value_or(0.0)};
  }
  return {0.0, 0.0, log.samples.empty() ? 0.0 : log.samples.front().reference_theta_rad.value_or(0.0)};
}

}  // namespace

std::vector<PredictedMotion> free_run(const LinearModel& model, const DriveLog& log) {
  std::vector<PredictedMotion> motion;
  if (log.samples.empty()) return motion;
  motion.reserve(log.samples.size());
  const CommandTimeline timeline(log);
  const double t0 = log.samples.front().t_s;
  const double period = model.period_s;
  LinearPredictor predictor(model);

  PredictedMotion at_cell_start{t0, {}, {}, {}, start_pose(log)};
  motion.push_back(at_cell_start);
  std::size_t row = 1;
  for (std::size_t cell = 0; row < log.samples.size(); ++cell) {
    const double from = t0 + period * static_cast<double>(cell);
    const double to = t0 + period * static_cast<double>(cell + 1);
    const WheelPair speed = predictor.step(timeline.mean_m_s(from, to));
    const Twist twist = twist_of_wheels(speed, model.wheel_base_m);
    const auto moved = [&](double t) {
      const double duration = t - from;
      const WheelPair& before = at_cell_start.distance_m;
      return PredictedMotion{t,
                             speed,
                             twist,
                             {before.left + speed.left * duration, before.right + speed.right * duration},
                             move_along_arc(at_cell_start.pose, twist, duration)};
    };
    // Times are printed with microseconds, so a row on the grid may lie that much behind it.
    const double end_of_cell = to + 1e-4 * period;
    for (; row < log.samples.size() && log.samples[row].t_s <= end_of_cell; ++row) {
      motion.push_back(moved(log.samples[row].t_s));
    }
    at_cell_start = moved(to);
  }
  return motion;
}

}  // namespace wheelwright
