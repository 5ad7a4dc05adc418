#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::sixth {

// The commands of a run, where it begins, and the seed of what disturbs it.
struct DriveScript {
  std::vector<double> time_s;
  std::vector<PerWheel<double>> command_m_s;
  Pose start;
  std::uint64_t noise_seed = 0;
};

}  // namespace plants::sixth
