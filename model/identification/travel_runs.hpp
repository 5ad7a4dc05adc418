// Runs as readings of wheel travel on the periods of a model, in the form that repeated passes want.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// A reading of the encoders at its real time.
struct TravelReading {
  std::size_t period = 0;      // of the model in which it lies, or at whose end
  double share = 0.0;          // of that period that has passed
  WheelPair travel_m;          // of each wheel since the first reading of the run
  double periods_since = 0.0;  // the reading before
  double fastest_m_s = 0.0;    // mean command of the faster wheel in the last few periods
  bool restart = false;        // travel between the reading before and this one cannot be predicted
};

struct TravelRun {
  std::vector<WheelPair> commands_m_s;  // mean over each period, from the first row on
  std::vector<TravelReading> readings;
};

// Readings after a hole are left out until its commands, which are not known, have been forgotten.
std::vector<TravelRun> travel_runs(std::span<const DriveLog> logs, double period_s);

}  // namespace wheelwright
