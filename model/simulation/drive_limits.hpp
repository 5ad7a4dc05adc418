// What a model says of the commands by which its robot can be steered.
#pragma once

#include <limits>

namespace wheelwright {

struct DriveLimits {
  // The turn rate up to which a robot that drives ahead turns by less than half of what is asked for, as with
  // tyres that scrub; 0 where it follows any.
  double turn_dead_band_rad_s = 0.0;
  // Speed that each wheel reaches, forward and backward.
  double fastest_wheel_m_s = std::numeric_limits<double>::infinity();
  // A robot in a curve turns on for a while when it is told to go straight, and when it is told to stop.
  // Where these turns differ, as with motors that cannot brake: periods after which the first has ended; else
  // 0.
  int straightening_periods = 0;
};

}  // namespace wheelwright
