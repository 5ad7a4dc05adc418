// Segments in which a counter misses a part of its edges: dirt on the disc, a sensor at the edge of its
// range.
//
// What the counts should be is told by the commands, through a short linear response that is fitted to the
// log itself. A wheel that is slow for a reason slows down and speeds up as a motor can, or when it is told
// to; a counter that misses edges does so from one row to the next, in both directions, at a steady command.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

struct ThinnedCounts {
  std::size_t first_row = 0;  // whose counts since the row before are too few
  std::size_t last_row = 0;
  double lost = 0.0;    // share of the edges
  double lost_m = 0.0;  // travel, with its sign
};

// Of one wheel of a log that has ticks, in order. `left_out` has one flag per row.
std::vector<ThinnedCounts> find_missed_encoder_edges(const DriveLog& log, std::span<const char> left_out,
                                                     bool left);

}  // namespace wheelwright::gap
