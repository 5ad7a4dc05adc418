#pragma once

#include "tests/benchmark/fourth_plant/robot.hpp"

namespace plants::fourth {

// What is around the motor.
enum class Loop { any, open, proportional, integral };

// A linear robot; both wheels alike in gain, and nearly in lag.
Robot random_robot(Loop loop, Random& random);

}  // namespace plants::fourth
