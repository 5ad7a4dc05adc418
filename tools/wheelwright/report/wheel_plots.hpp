// Commands, wheel speeds, wheel travel, path and heading of a drive log, beside what models make of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/prediction/free_run.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {

enum class Side : unsigned char { left, right };

// A model's free run over a log, as it is to be drawn.
struct DrawnRun {
  std::string name;
  Ink ink;
  const std::vector<PredictedMotion>* motion;  // one entry per row of the log
};

// One picture per wheel: command, measured speed, and the model's, over the first `longest_s` seconds.
// Measured is the mean over about 0.1 s: one period is a handful of ticks.
std::vector<Plot> sequence_plots(const DriveLog& log, const std::vector<PredictedMotion>& motion,
                                 double longest_s);

// Predicted minus measured travel of each wheel: solid the left, dashed the right. The log has counts.
Plot travel_error_plot(const DriveLog& log, std::span<const DrawnRun> runs);

// The path on the floor by each model, beside the reference poses of the log.
Plot path_plot(const DriveLog& log, std::span<const DrawnRun> runs);

// Predicted minus measured heading, both since the first one that was measured.
Plot heading_error_plot(const DriveLog& log, std::span<const DrawnRun> runs);

// Whether a log has enough headings of a reference for a line.
bool has_headings(const DriveLog& log);

// Whether a log has enough reference poses for a path.
bool has_path(const DriveLog& log);

}  // namespace wheelwright::tools
