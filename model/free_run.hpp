// The model on its own: commands of a log in, predicted motion out, at the log's own times.
#pragma once

#include <vector>

#include "model/drive_log.hpp"
#include "model/linear_model.hpp"

namespace wheelwright {

// Predicted motion at one row of a log.
struct PredictedMotion {
  double t_s = 0.0;
  WheelPair speed_m_s;   // mean over the period that ends at this row
  Twist twist;           // the same as body motion
  WheelPair distance_m;  // travelled by each wheel since the first row
  Pose pose;             // starts at the first reference pose of the log, else at zero
};

// Free run from rest over the whole log; one entry per row. The log may have any period and gaps: the last
// command holds through a gap, as it does on the robot.
std::vector<PredictedMotion> free_run(const LinearModel& model, const DriveLog& log);

}  // namespace wheelwright
