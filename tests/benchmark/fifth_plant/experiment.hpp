#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmark/fifth_plant/person.hpp"
#include "tests/benchmark/fifth_plant/robot.hpp"
#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"

namespace plants::fifth {

// What the runs of a case have in common.
struct Experiment {
  Robot robot;
  SensorSet sensors;
  Programme programme = Programme::teleoperation;
  Style style;
  std::uint64_t seed = 0;
  std::uint64_t noise_seed = 0;  // of the disturbances and sensors
  int runs = runs_of_a_case;
};

std::vector<Run> drive(const Experiment& experiment);
// The same commands as in runs that were driven before.
std::vector<Run> drive_again(const Experiment& experiment, const std::vector<Run>& driven);

}  // namespace plants::fifth
