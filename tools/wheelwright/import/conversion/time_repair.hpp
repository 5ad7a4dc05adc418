// What the clock of a log says, made a time that rises: rows that were written out of order are sorted, a
// stamp that occurs twice is dropped, and where the clock was set or the log pauses a new run begins. Nothing
// is joined across such a place, so that the time spent on a run does not grow with a hole.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace wheelwright::import {

// A run ends where nothing was written for so long, and for so many steps of the clock.
inline constexpr double longest_pause_s = 60.0;
inline constexpr double longest_pause_steps = 50.0;

// Rows of one run in the order of time.
using RunRows = std::vector<std::size_t>;

struct TimeRepair {
  std::vector<RunRows> runs;
  std::vector<std::string> remarks;  // one line each, with the place
  std::vector<double> t_s;           // of all rows
  std::size_t set_back = 0;          // how often the clock went back, rows that were sorted left out
};

// Rows of a clock that is coarser than they are (a third of them and more have the stamp of the row before)
// are spread evenly up to its next step. Returns how many had the stamp of the row before; 0 where nothing
// was done.
std::size_t spread_coarse_stamps(std::vector<double>& t_s);

// What is asked about rows.
struct RowQuestions {
  std::function<std::string(std::size_t)> place;            // its name, for a remark
  std::function<bool(std::size_t, std::size_t)> are_alike;  // but for the time
  std::function<bool(std::size_t)> is_at_rest;              // whether the robot is asked to stand
};

// Of the steps forward; 0 where there are none.
double median_step_s(std::span<const double> t_s);

TimeRepair repair_time(std::span<const double> t_s, const RowQuestions& rows);

}  // namespace wheelwright::import
