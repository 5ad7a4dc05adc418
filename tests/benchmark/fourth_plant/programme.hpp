#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::fourth {

// How a robot is driven: scripts that know the time and, at most, what they have commanded so far.
enum class Programme {
  random_steps,
  multi_sine,
  waypoints,        // forward only
  laps,             // forward only
  stairs,           // slow ramps and stairs through zero, with bends
  straight_stairs,  // the same without bends
  chirp,
  stop_and_go,
  spins,
};

std::string name_of(Programme programme);

struct DriveLimits {
  double wheel_base_m = 0.25;
  double fastest_m_s = 0.4;  // of a wheel
  double fastest_turn_rad_s = 2.5;
};

// One command for each row; at rest in the beginning and at the end.
std::vector<PerWheel<double>> make_commands(Programme programme, const DriveLimits& limits, double period_s,
                                            double duration_s, Random random);

}  // namespace plants::fourth
