// What the clock of a log says, made a time that rises: rows that were written out of order are sorted, a
// stamp that stands twice is dropped, and where the clock was set or the log pauses a new run begins. Nothing
// is joined across such a place, so that the time spent on a run does not grow with a hole.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace wheelwright::import {

// Rows of one run in the order of time.
using RunRows = std::vector<std::size_t>;

struct TimeRepair {
  std::vector<RunRows> runs;
  std::vector<std::string> remarks;  // one line each, with the place
};

// `place` names a row for a remark; `same` says whether two rows are alike but for the time.
TimeRepair repair_time(std::span<const double> t_s, const std::function<std::string(std::size_t)>& place,
                       const std::function<bool(std::size_t, std::size_t)>& same);

}  // namespace wheelwright::import
