// One attempt of Table II: a simulated robot calibrates itself and drives the route once with each contender.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "model/brain/mission.hpp"
#include "model/pose.hpp"
#include "model/route/route.hpp"
#include "tools/wheelwright/evaluation/contender.hpp"

namespace wheelwright::tools {

// How often the robot calibrates itself: encoder scale, response actions, random drive. The paper does not
// say. Its 30 attempts are called independent, which with a model that is fitted once they are not: all would
// have the same static error. So `each` is what Table II is compared with. `once` shows how much of the
// scatter comes from driving.
enum class Calibrate { each, once };

struct EvaluationPlan {
  simulation::SimulationConfig robot;
  Route route;  // closed
  RobotLimits limits;
  roomba::LinkConfig link;
  std::uint64_t seed = 1;
  Calibrate calibrate = Calibrate::each;
};

// How one drive ended.
struct DriveOutcome {
  std::optional<Pose> end;  // truly, as seen from where the route was begun; absent if it did not get there
  std::string failure;      // then: why
};

using AttemptOutcome = std::array<DriveOutcome, contenders.size()>;  // in the order of `contenders`

// Depends on nothing but its arguments. From the plan's seed and the attempt's number come the battery's
// charge, where the robot is put down, how its wheels stand, the phase of its clocks, its counters, and all
// noise; each drive begins with fresh ones of all but charge.
AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number);

}  // namespace wheelwright::tools
