// How fast a robot goes by its reference and by itself, on even grids of time, to compare the clocks of both.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct SpeedGrid {
  double step_s = 0.0;
  double window_s = 0.0;  // over which a speed is a mean; a whole number of steps
  std::size_t max_points = 40'000;
};

// Mean speeds over windows, a step apart.
struct GridSpeeds {
  double start_s = 0.0;  // of the first window
  std::vector<double> values;
};

// By the places of the reference, in its unit. Empty where it has none.
GridSpeeds reference_speeds(std::span<const Recording> recordings, const Mapping& mapping,
                            const SpeedGrid& grid);

// Of the middle of the wheels, without wheels of the commands, in any unit.
GridSpeeds robot_speeds(std::span<const Recording> recordings, const Mapping& mapping, const SpeedGrid& grid);

}  // namespace wheelwright::import
