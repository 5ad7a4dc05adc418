// What a model predicts over the horizon of a score.
//
// A free run that has gone astray meets no edge of a rug and no slope where the robot does: of where effects
// act by place or heading it tells less and less, and so of a wheel that is not round when the way of the
// wheels has gone astray by a part of a turn. Ten runs are each told every ten seconds where the robot is and
// how far its wheels have rolled, a second after one another, so that for each window of a score one begins
// it with what was measured.
#pragma once

#include <vector>

#include "model/log/drive_log.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Whether a model is told anything on its way through a log.
bool is_reset_to_measured_pose(const RobotModel& model, const DriveLog& log);

// A single free run where no effect of the model acts by place, heading or the wheels' angle.
std::vector<std::vector<PredictedMotion>> open_loop_runs(const RobotModel& model, const DriveLog& log);

// Adds how far they are from the log, between its holes.
void add_open_loop(const RobotModel& model, const DriveLog& log, ScoreSums& sums);

}  // namespace wheelwright
