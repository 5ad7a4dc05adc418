// One attempt of Table II: a simulated robot calibrates itself and drives the route once with each contender.
//
// The paper speaks of 30 independent attempts, and its moving-average model scatters four times as much as
// its ARMA model (0.095 m against 0.021 m) although both are driven open loop on the same robot and floor.
// Only what differs between the two, the calibration, can do that, so that each attempt has a calibration of
// its own: four response actions for the moving average, some hundred rows of random driving for ARMA.
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

struct EvaluationPlan {
  simulation::SimulationConfig robot;
  Route route;  // closed
  RobotLimits limits;
  roomba::LinkConfig link;
  std::uint64_t seed = 1;
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
