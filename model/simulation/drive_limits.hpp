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
};

}  // namespace wheelwright
