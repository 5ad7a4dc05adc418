// Of logs that are longer than an analysis can take, the parts that show the most.
#pragma once

#include <cstddef>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

struct SegmentLimits {
  std::size_t max_rows = 60'000;  // of all runs together
  double length_s = 60.0;         // of a segment
};

struct Segments {
  std::vector<DriveLog>
      runs;  // the segments in order of time; the logs as they are where nothing is left out
  double used_s = 0.0;
  double given_s = 0.0;

  bool all_used() const { return used_s == given_s; }
};

// Logs that have no more rows than that stay as they are. Else each is cut where the robot stood, and
// segments are chosen one after the other, each for what it adds: sizes and changes of command, turns,
// places, headings, battery voltages and parts of the run that those before it hold little of. Whoever looks
// at more of the same learns little: what something is worth grows with the logarithm of its time.
Segments informative_segments(std::vector<DriveLog> logs, const SegmentLimits& limits);

}  // namespace wheelwright::gap
