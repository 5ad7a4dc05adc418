// Which of two models is to drive a route: the one that predicts drives better that neither has seen.
#pragma once

#include <optional>
#include <span>

#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::tools {

// Root mean square of how far a free run from the start is off the reference position, over all rows of the
// drives, in m; absent where no log has a reference position. Windows of some seconds would not do: errors of
// heading that hardly show in them decide where a route ends.
std::optional<double> position_error_m(const RobotModel& model, std::span<const DriveLog> logs);

}  // namespace wheelwright::tools
