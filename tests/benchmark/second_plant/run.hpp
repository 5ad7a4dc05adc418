#pragma once

#include <vector>

#include "tests/benchmark/second_plant/drive_log.hpp"
#include "tests/benchmark/second_plant/plant.hpp"
#include "tests/benchmark/second_plant/programme.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace second_plant {

// The motion that no sensor disturbed, for comparisons between two robots.
struct TrueRow {
  Pose reference_point;
  double heading_rad = 0.0;  // unwrapped
};

struct Run {
  DriveLog log;
  std::vector<TrueRow> truth;
};

// Start heading of the runs that all point the same way.
inline constexpr double kKeptHeading_rad = 0.4;

// Drives the programme once. The same `random` gives the same noise, jitter and start pose to any robot.
Run drive_run(const RobotSpec& robot, const SensorSet& sensors, const Programme& programme, int run_index,
              bool keep_heading, const Random& random);

}  // namespace second_plant
