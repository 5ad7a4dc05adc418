// How well a command explains a measured speed: a finite impulse response by least squares.
#pragma once

#include <cstddef>
#include <cstdint>
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
  double at_zero = 0.0;    // steady speed at a command of 0; other than 0 only of Baseline::any
  double explained = 0.0;  // share of the variance of the speed, 0 to 1
  double nats = 0.0;       // log likelihood over that of a constant speed
};

// Whether a command of 0 means that the wheel stands, or another number does, as 1500 us of a remote control.
enum class Baseline : std::uint8_t { zero, any };

// All zero where there are fewer than 20 rows, or nothing changes.
ResponseFit fit_response(const ResponseRows& rows, Baseline baseline = Baseline::zero);

}  // namespace wheelwright::import
