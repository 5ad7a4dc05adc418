#pragma once

#include <vector>

#include "tests/benchmark/plants/drive_log.hpp"
#include "tests/benchmark/plants/pose.hpp"

namespace plants {

// The motion that no sensor disturbed, for comparisons between two robots.
struct TrueRow {
  Pose reference_point;
  double heading_rad = 0.0;  // unwrapped
};

struct Run {
  DriveLog log;
  std::vector<TrueRow> truth;
};

}  // namespace plants
