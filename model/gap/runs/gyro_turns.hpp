// How far a robot turned, by a gyro.
//
// A raw gyro tells too much by a bias that nobody knows, and too much or too little by a scale that is off by
// a per cent or so. Neither is the robot's: the bias of each run is the steady rate under which what a model
// leaves is the least (of a random walk, which integrated noise is), and the scale is found beside the
// linear part. So a wrong wheel base and a wrong scale of the gyro cannot be distinguished.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/gap/runs/run.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// Whether nearly every row holds the gyro's rate, so that it can be integrated.
bool has_gyro(const DriveLog& log);

struct GyroTurn {
  std::size_t row = 0;
  double turned_rad = 0.0;  // since the first one, with the gyro's bias in it
};

// By trapezoids, from the first row that holds a rate on. Empty where there is no gyro.
std::vector<GyroTurn> gyro_turns(const DriveLog& log);

// Radians by which the gyro of a run turned beyond what the model predicts, bias and all, less the line that
// its bias leaves in it.
struct GyroErrors {
  std::vector<double> errors_rad;
  double drift_rad_s = 0.0;  // that was taken out
};
GyroErrors without_drift(const GapRun& run, std::vector<double> errors_rad);

// Puts what the gyro says into a log as its headings, where it holds no others, so that figures can be drawn
// and computed of them: without drift, and by the true scale. `scale` is relative, 0.01 for one per cent too
// much.
void lay_gyro_headings(DriveLog& log, double drift_rad_s, double scale);

}  // namespace wheelwright::gap
