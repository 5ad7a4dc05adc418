// The commands of a run as functions of time: each holds from its row until the next.
#pragma once

#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// The integral of the commands over time. Before the first row the robot is at rest; after the last row the
// last command holds.
class CommandTimeline {
 public:
  explicit CommandTimeline(const DriveLog& log);

  // Commanded distance of each wheel, in metres, from the first row to time t.
  WheelPair distance_m(double t_s) const;

  // Mean command over an interval.
  WheelPair mean_m_s(double from_s, double to_s) const;

 private:
  const DriveLog& log_;
  std::vector<WheelPair> distance_at_row_m_;
};

}  // namespace wheelwright
