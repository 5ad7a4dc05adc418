#pragma once

#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/sixth_plant/drive_script.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// One run, with a pose in every row. With `engaged` the teeth of the gears touch from the start.
Run simulate(const Robot& robot, const Hidden& hidden, const DriveScript& script, bool engaged = false);

}  // namespace plants::sixth
