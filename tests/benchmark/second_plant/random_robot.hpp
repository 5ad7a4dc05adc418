#pragma once

#include "tests/benchmark/second_plant/random.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace second_plant {

// How hard the wheel controller holds the speed against a load.
enum class Drive {
  any,
  soft,   // feed-forward only or a little P, slow: loads show in the speed
  stiff,  // fast PI: loads hardly show
};

RobotSpec random_robot(Drive drive, Random& random);

}  // namespace second_plant
