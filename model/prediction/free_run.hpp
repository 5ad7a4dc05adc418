// The model on its own: commands of a log in, predicted motion out, at the log's own times.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Predicted motion at one row of a log.
struct PredictedMotion {
  double t_s = 0.0;
  WheelPair speed_m_s;      // of the wheels on the floor, mean over the period that ends at this row
  Twist twist;              // of the body
  WheelPair distance_m;     // since the first row, as the encoders count it
  Pose pose;                // as a reference measures it; starts at the log's first one, else at zero
  double free_for_s = 0.0;  // since the run began, or was told what is measured
};

using Prediction = std::span<const PredictedMotion>;  // one entry per row of a log

// Free run from rest over the whole log; one entry per row. The log may have any period and gaps: the last
// command holds through a gap, as it does on the robot.
std::vector<PredictedMotion> free_run(const RobotModel& model, const DriveLog& log);

// The same for a model without effects, and for a linear part with effects.
std::vector<PredictedMotion> free_run(const LinearModel& model, const DriveLog& log);
// `reset_rows`, in order: there effects that act by place or heading are told where the robot is, by the
// row's reference, and those that act by the wheels' angle how far they have rolled, by the counts. The path
// and the way of the wheels that the run returns stay its own.
std::vector<PredictedMotion> free_run(const LinearModel& linear_part, std::span<const EffectSetting> effects,
                                      const DriveLog& log, std::span<const std::size_t> reset_rows = {});

}  // namespace wheelwright
