#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"
#include "tests/benchmark/second_plant/programme.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// Start heading of the runs that all point the same way.
inline constexpr double kKeptHeading_rad = 0.4;

// Drives the programme once. The same `random` gives the same noise, jitter and start pose to any robot.
Run drive_run(const RobotSpec& robot, const SensorSet& sensors, const Programme& programme, int run_index,
              bool keep_heading, const Random& random);

}  // namespace plants::second
