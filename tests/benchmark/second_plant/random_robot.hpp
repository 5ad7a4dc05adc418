#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// How hard the wheel controller holds the speed against a load.
enum class Drive {
  any,
  soft,   // feed-forward only or a little P, slow: loads show in the speed
  stiff,  // fast PI: loads hardly show
};

RobotSpec random_robot(Drive drive, Random& random);

}  // namespace plants::second
