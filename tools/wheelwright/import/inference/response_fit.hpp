// How well a command explains a measured speed: a finite impulse response by least squares.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"

namespace wheelwright::import {

// Measured speed and command per row, in the order of time, of several runs.
struct ResponseRows {
  std::vector<double> speed;    // over the time since the row before, in units of the channel per second
  std::vector<double> command;  // in force over that time
  std::vector<std::size_t> run_ends;  // one behind the last row of each run
};

struct ResponseFit {
  double gain = 0.0;       // steady speed per unit of the command
  double explained = 0.0;  // share of the variance of the speed, 0 to 1
  double nats = 0.0;       // log likelihood over that of a constant speed
};

// All zero where there are fewer than 20 rows, or nothing changes.
ResponseFit fit_response(const ResponseRows& rows);

}  // namespace wheelwright::import
