// The numbers of a model into an SDF or URDF file.
#pragma once

#include "tools/wheelwright/export/patch/patch.hpp"
#include "tools/wheelwright/export/sdf.hpp"

namespace wheelwright::tools {

// Throws UsageError, in one line, where the file has no DiffDrive plugin or not its joints, or more than one
// of them. A URDF file without the plugin takes the dynamics of its joints alone.
Patch patch_sdf(const PatchedFile& file, const RobotModel& model, const WheelGeometry& wheel,
                const PatchNames& names);

}  // namespace wheelwright::tools
