// A model as MJCF: the joints and actuators of its two wheels.
#pragma once

#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

// With an inertia; throws std::invalid_argument, in one line, where the linear part leaves no torque to be
// had.
ModelText to_mujoco(const RobotModel& model, const WheelGeometry& wheel);

}  // namespace wheelwright::tools
