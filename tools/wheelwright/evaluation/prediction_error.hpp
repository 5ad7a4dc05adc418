// Which of two models is to drive a route: the one that predicts drives better that neither has seen.
#pragma once

#include <optional>
#include <span>

#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::tools {

// Root mean square of how far a free run is off the reference position after 10 s, in m
// (model/prediction/score.hpp); absent where no log has a reference pose.
std::optional<double> position_error_m(const RobotModel& model, std::span<const DriveLog> logs);

}  // namespace wheelwright::tools
