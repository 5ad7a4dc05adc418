#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmark/fourth_plant/programme.hpp"
#include "tests/benchmark/fourth_plant/robot.hpp"
#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"

namespace plants::fourth {

// What the runs of a case have in common.
struct Experiment {
  Robot robot;
  SensorSet sensors;
  Programme programme = Programme::random_steps;
  DriveLimits limits;
  std::uint64_t seed = 0;
};

std::vector<Run> drive(const Experiment& experiment);

}  // namespace plants::fourth
