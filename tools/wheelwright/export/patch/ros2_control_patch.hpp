// The numbers of a model into a YAML file of ros2_control or Nav2.
#pragma once

#include "tools/wheelwright/export/patch/patch.hpp"
#include "tools/wheelwright/export/ros2_control.hpp"

namespace wheelwright::tools {

// Throws UsageError, in one line, where the file has neither a diff_drive_controller nor a velocity_smoother,
// or several.
Patch patch_ros2_control(const PatchedFile& file, const RobotModel& model, double wheel_radius_m,
                         const PatchNames& names);

}  // namespace wheelwright::tools
