#pragma once

#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::second {

// One command per row of the log.
using Programme = std::vector<PerWheel<double>>;

enum class Style {
  rich,               // straights, arcs, pivots, ramps, sines, creeping, stand-stills
  gentle_forward,     // slow changes, always moving forward
  straight_only,      // both wheels always alike
  one_speed,          // each wheel stands or drives at one speed
  no_small_commands,  // as rich, but nothing between 0 and a third of the top speed
  one_heading,        // straight ahead, never standing, never backwards
};

struct ProgrammeLimits {
  double period_s = 0.018;
  double duration_s = 75.0;
  double fastest_m_s = 0.4;
  double track_m = 0.25;
  double room_radius_m = 1.2;
};

// The speed of `Style::one_speed`.
inline double one_speed_m_s(double fastest_m_s) {
  return 0.7 * fastest_m_s;
}

Programme random_programme(Style style, const ProgrammeLimits& limits, Random random);

}  // namespace plants::second
