// Drives whose reference saw what the counts say.
#pragma once

#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::test {

inline DriveLog by_counts(DriveLog log) {
  Pose pose;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    DriveSample& sample = log.samples[i];
    if (i > 0) {
      const WheelTicks& before = *log.samples[i - 1].ticks;
      const WheelPair moved{
          static_cast<double>(sample.ticks->left - before.left) * log.metres_per_tick->left,
          static_cast<double>(sample.ticks->right - before.right) * log.metres_per_tick->right};
      pose = move_along_arc(pose, twist_of_wheels(moved, log.wheel_base_m), 1.0);
    }
    sample.reference_x_m = pose.x_m;
    sample.reference_y_m = pose.y_m;
    sample.reference_theta_rad = pose.theta_rad;
  }
  return log;
}

}  // namespace wheelwright::test
