#pragma once

#include <functional>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"
#include "tests/benchmark/third_plant/robot_spec.hpp"

namespace plants::third {

struct Outing {
  int run = 0;
  double duration_s = 75.0;
  Pose start;
};

// Gives the command of a row to someone who sees where the robot is.
using Commander = std::function<PerWheel<double>(std::size_t row, double now_s, const Pose& seen)>;

// Drives once. The same `random` gives the same noise and jitter to any robot.
Run drive_run(const RobotSpec& robot, const SensorSet& sensors, const Outing& outing,
              const Commander& commander, const Random& random);

}  // namespace plants::third
