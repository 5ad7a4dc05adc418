// The numbers of a model into an MJCF file.
#pragma once

#include "tools/wheelwright/export/mujoco.hpp"
#include "tools/wheelwright/export/patch/patch.hpp"

namespace wheelwright::tools {

// What the file cannot say of itself.
struct MujocoChoice {
  double control_per_rad_s = 1.0;
  bool knows_delay = true;
};

// Throws UsageError, in one line, where the file has not the two wheels, or leaves open which they are.
Patch patch_mujoco(const PatchedFile& file, const RobotModel& model, const WheelGeometry& wheel,
                   const MujocoChoice& choice, const PatchNames& names);

}  // namespace wheelwright::tools
