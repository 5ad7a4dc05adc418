// One attempt of Table II: a simulated robot calibrates itself and drives the route once with each candidate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "model/brain/mission.hpp"
#include "model/route/route.hpp"
#include "tools/wheelwright/evaluation/candidate.hpp"
#include "tools/wheelwright/evaluation/robot_trial.hpp"

namespace wheelwright::tools {

// How often the robot calibrates itself: encoder scale, response actions, random drive. The paper does not
// say. Its 30 attempts are called independent, which with a model that is fitted once they are not: all would
// have the same static error. So `each` is what Table II is compared with. `once` shows how much of the
// scatter comes from driving.
enum class Calibrate { each, once };

// What the gap workflow made of a robot; the same for all attempts.
struct GapModels {
  RobotModel refitted;
  RobotModel extended;
};

struct EvaluationPlan {
  simulation::SimulationConfig robot;
  Route route;  // closed
  RobotLimits limits;
  roomba::LinkConfig link;
  std::uint64_t seed = 1;
  Calibrate calibrate = Calibrate::each;
  std::optional<GapModels> gap;  // without it, the candidates that need it are left out
};

// The robot of an attempt: the battery's charge belongs to the attempt, everything else to each run.
// Calibrating and driving do not share their luck.
enum class Purpose : std::uint8_t { calibrate, drive };
RobotTrial trial_of(const EvaluationPlan& plan, std::uint64_t number, Purpose purpose);

// In the order of `candidates`; nothing for one that was left out.
using AttemptOutcome = std::array<std::optional<DriveOutcome>, candidates.size()>;

// Depends on nothing but its arguments. From the plan's seed and the attempt's number come the battery's
// charge, where the robot is put down, how its wheels stand, the phase of its clocks, its counters, and all
// noise; each drive begins with fresh ones of all but charge.
AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number);

}  // namespace wheelwright::tools
