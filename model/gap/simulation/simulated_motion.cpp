#include "model/gap/simulation/simulated_motion.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
namespace {

struct Moment {
  WheelPair distance_m;
  Pose pose;
};

bool has_poses(const DriveLog& log) {
  return std::ranges::any_of(log.samples,
                             [](const DriveSample& sample) { return sample.reference_pose().has_value(); });
}

// Of what a row does not hold, the newest that was told before.
std::vector<Moment> moments_of(const DriveLog& log) {
  std::vector<Moment> moments;
  moments.reserve(log.samples.size());
  const WheelPair scale = log.metres_per_tick.value_or(WheelPair{});
  std::optional<WheelTicks> first;
  Moment now;
  for (const DriveSample& sample : log.samples) {
    if (sample.ticks && !first) first = sample.ticks;
    if (sample.ticks) {
      now.distance_m = {static_cast<double>(sample.ticks->left - first->left) * scale.left,
                        static_cast<double>(sample.ticks->right - first->right) * scale.right};
    }
    now.pose = sample.reference_pose().value_or(now.pose);
    moments.push_back(now);
  }
  return moments;
}

Moment between(const Moment& before, const Moment& after, double share) {
  const Pose step = between(before.pose, after.pose);
  return {{std::lerp(before.distance_m.left, after.distance_m.left, share),
           std::lerp(before.distance_m.right, after.distance_m.right, share)},
          compose(before.pose, {share * step.x_m, share * step.y_m, share * step.theta_rad})};
}

// What both can show.
DriveLog comparable(const DriveLog& real, const DriveLog& simulated) {
  DriveLog log = real;
  const bool ticks = simulated.has_ticks();
  const bool poses = has_poses(simulated);
  if (!ticks) log.metres_per_tick.reset();
  for (DriveSample& sample : log.samples) {
    if (!ticks) sample.ticks.reset();
    if (poses) continue;
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
    sample.reference_theta_rad.reset();
  }
  return log;
}

}  // namespace

std::vector<PredictedMotion> simulated_motion(const DriveLog& simulated, const DriveLog& real) {
  const std::vector<Moment> moments = moments_of(simulated);
  const double ahead_s = simulated.samples.front().t_s - real.samples.front().t_s;
  std::vector<PredictedMotion> motion;
  motion.reserve(real.samples.size());
  std::size_t next = 0;
  for (const DriveSample& sample : real.samples) {
    const double t_s = sample.t_s + ahead_s;
    while (next < moments.size() && simulated.samples[next].t_s <= t_s) ++next;
    Moment at = next == 0 ? moments.front() : moments[next - 1];
    if (next > 0 && next < moments.size()) {
      const double from_s = simulated.samples[next - 1].t_s;
      at = between(at, moments[next], (t_s - from_s) / (simulated.samples[next].t_s - from_s));
    }
    PredictedMotion row;
    row.t_s = sample.t_s;
    row.distance_m = at.distance_m;
    row.pose = at.pose;
    row.free_for_s = sample.t_s - real.samples.front().t_s;
    if (!motion.empty()) {
      const PredictedMotion& last = motion.back();
      const double duration_s = row.t_s - last.t_s;
      row.speed_m_s = {(row.distance_m.left - last.distance_m.left) / duration_s,
                       (row.distance_m.right - last.distance_m.right) / duration_s};
      row.twist = twist_of_wheels(row.speed_m_s, real.wheel_base_m);
    }
    motion.push_back(row);
  }
  return motion;
}

Score score_of_simulation(std::span<const DriveLog> simulated, std::span<const DriveLog> real) {
  ScoreSums sums;
  for (std::size_t run = 0; run < std::min(simulated.size(), real.size()); ++run)
    sums.add(simulated_motion(simulated[run], real[run]), comparable(real[run], simulated[run]));
  return sums.score();
}

}  // namespace wheelwright::gap
