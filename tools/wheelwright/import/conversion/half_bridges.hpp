// Commands of a motor driver with two inputs for each motor, one forward and one backward (L298N, TB6612).
#pragma once

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// "in1" to "in4", of which one of each two is always 0, become "pwm_1" and "pwm_2": forward less backward.
// Where they are bits beside "ena" and "enb", these are the size. Streams without them stay as they are;
// whether it was one with them.
bool join_half_bridges(Stream& stream);

}  // namespace wheelwright::import
