// A model as SDF: Gazebo's DiffDrive plugin, and the dynamics of its wheel joints.
#pragma once

#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

// Those of the joints with an inertia only.
ModelNumbers sdf_numbers(const RobotModel& model, const WheelGeometry& wheel);

ModelText to_sdf(const RobotModel& model, const WheelGeometry& wheel);

}  // namespace wheelwright::tools
