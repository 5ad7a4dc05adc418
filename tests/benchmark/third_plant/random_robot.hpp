#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/third_plant/robot_spec.hpp"

namespace plants::third {

enum class Loop { any, open, closed };

// Time constant of the wheel speed.
enum class Response {
  any,
  middling,  // slow enough to be seen, fast enough to be told from the commands
  quick,     // the commands ask for more than a limited motor or tyre can give
};

RobotSpec random_robot(Loop loop, Response response, Random& random);

}  // namespace plants::third
