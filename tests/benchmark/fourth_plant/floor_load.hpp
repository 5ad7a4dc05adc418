// Blocks in the motor's place that know where the robot is.
#pragma once

#include <cmath>

#include "tests/benchmark/fourth_plant/block.hpp"
#include "tests/benchmark/fourth_plant/body_blocks.hpp"

namespace plants::fourth {

// Uphill the motors lose speed, downhill they gain it; a gear at rest holds.
struct GravityLoad {
  double speed_m_s;
  double downhill_rad;
  double operator()(double motor_m_s, const Moment& moment) const {
    return -speed_m_s * rolling(motor_m_s) * std::cos(moment.pose.heading_rad - downhill_rad);
  }
};

// A carpet brakes the motors in proportion to their speed.
struct Carpet {
  Disc disc;
  double share;
  double operator()(double drive_m_s, const Moment& moment) const {
    return disc.holds(moment.pose) ? share * drive_m_s : drive_m_s;
  }
};

}  // namespace plants::fourth
