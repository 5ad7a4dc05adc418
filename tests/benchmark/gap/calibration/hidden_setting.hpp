// An effect of the library with parameters drawn between the sizes at which a search begins.
#pragma once

#include "model/effects/effect.hpp"
#include "tests/benchmark/gap/calibration/random_drive_log.hpp"

namespace wheelwright::calibration {

// Of the first variant. A place is one that the robot passes in `drive`, by `model`.
EffectSetting random_setting(const EffectInfo& info, const RobotModel& model, const DriveLog& drive,
                             Random& random);

}  // namespace wheelwright::calibration
