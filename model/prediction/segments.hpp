// A run with holes: the parts of it in which commands and motion are known.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"

namespace wheelwright {

// More periods than longest_step_periods (run_periods.hpp) between two rows. The robot went on, but with
// which commands is not known, so that no model can say how far.
struct LogHole {
  std::size_t row = 0;  // the first behind it
  double duration_s = 0.0;
};

// In order. None in a log without encoder counts: its rows are events, each in force until the next.
std::vector<LogHole> find_holes(const DriveLog& log);

// Adds to `sums` how far the free run is from each segment between holes, each measured from its own start.
// What follows a hole is left out until its commands have been forgotten (60 periods of `model_period_s`),
// since the robot may have come out of it at any speed. Predictions hold one entry per row of `log`.
void add_segments(std::span<const Prediction> runs, const DriveLog& log, double model_period_s,
                  ScoreSums& sums);
void add_segments(Prediction predicted, const DriveLog& log, double model_period_s, ScoreSums& sums);

}  // namespace wheelwright
