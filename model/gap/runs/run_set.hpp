// Runs that serve one purpose.
#pragma once

#include <cstddef>
#include <vector>

#include "model/gap/runs/run.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// Runs beside the logs that they were made of, as the gate left them.
struct RunSet {
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;  // of each run; zero without counts
  std::vector<DriveLog> logs;

  void add(GapRun run, const DriveLog& log);
  void move_to(RunSet& other, std::size_t index);
};

}  // namespace wheelwright::gap
