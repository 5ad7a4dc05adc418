// What the name of a channel says: "posL [mm]" is the travel of the left wheel, "/cmd_vel:linear.x" a
// commanded forward speed.
#pragma once

#include <cstdint>
#include <string>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

enum class Quantity : std::uint8_t {
  unknown,
  time,
  // of a wheel
  command,
  duty,
  count,
  angle,
  distance,
  speed,
  // of the body
  direction,  // a bit beside a duty
  throttle,
  steering,
  stick,      // an axis of a joystick
  radius,     // of a turn
  curvature,  // one over it
  linear_command,
  angular_command,
  linear_speed,
  angular_speed,
  travelled,  // how far the body went, forward
  turned,     // by how much
  x,
  y,
  z,
  latitude,
  longitude,
  heading,
  qx,  // of a quaternion; without a part w beside it, the turn about the axis
  qy,
  qz,
  qw,
  wanted,  // a place or heading to go to
  gyro,
  battery,
};

enum class NamedSide : std::uint8_t { none, left, right };

struct NameMeaning {
  Quantity quantity = Quantity::unknown;
  NamedSide side = NamedSide::none;
  std::string unit;  // as the file states it, or as the name ends ("speed_mm_s"); in its standard spelling
};

NameMeaning meaning_of(const Stream& stream, const Channel& channel);

}  // namespace wheelwright::import
