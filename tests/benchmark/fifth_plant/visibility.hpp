#pragma once

#include <string>

#include "tests/benchmark/fifth_plant/experiment.hpp"

namespace plants::fifth {

// How far a robot lies from the same one without what is hidden, on the same commands, in multiples of the
// noise; over short and long windows of two runs, of the channel and the window in which it is largest.
struct Visibility {
  double raw = 0.0;
  double bent = 0.0;  // what a linear model of the last seconds of commands cannot take up of it
  std::string channel;
};

// Noise is what the innocent robot does differently with other disturbances, and the noise of the sensors.
Visibility visibility(Experiment hidden, Experiment innocent);

}  // namespace plants::fifth
