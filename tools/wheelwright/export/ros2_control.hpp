// A model as parameters of ros2_control's diff_drive_controller and of Nav2's velocity smoother.
#pragma once

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

// `wheel_radius_m` is that of both wheels, as the encoders' counts were turned into metres.
ModelNumbers ros2_control_numbers(const RobotModel& model, double wheel_radius_m);

ModelText to_ros2_control(const RobotModel& model, double wheel_radius_m);

}  // namespace wheelwright::tools
