// One attempt of Table II: a simulated robot calibrates itself and drives the route once with each candidate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "model/brain/mission.hpp"
#include "model/route/route.hpp"
#include "tools/wheelwright/evaluation/calibration_drives.hpp"
#include "tools/wheelwright/evaluation/candidate.hpp"
#include "tools/wheelwright/evaluation/robot_trial.hpp"

namespace wheelwright::tools {

// What the gap workflow made of a robot.
struct GapModels {
  RobotModel refitted;
  RobotModel extended;
};

// What a robot knows of itself after its calibration.
struct CalibratedModels {
  MaybeModel fir;
  MaybeModel arma;
};

struct EvaluationPlan {
  simulation::SimulationConfig robot;
  Route route;  // closed
  RobotLimits limits;
  roomba::LinkConfig link;
  std::uint64_t seed = 1;
  Drives drives = Drives::shipped;
  std::optional<CalibratedModels> calibrated;  // of all attempts; without it, each calibrates itself
  std::optional<GapModels> gap;                // of all attempts
  bool learn_each =
      false;  // each attempt has a gap workflow of its own; with neither, its candidates are left out
  // Standard deviation of the right wheel's radius over the left one's, as a fraction, drawn for each attempt
  // instead of the robot's own. No calibration shows it: one robot is one draw, and no measure of how often
  // the truth lies inside an ellipse. 0: all attempts have the robot as it is.
  double wheel_mismatch = 0.0;
};

// The robot of an attempt: the battery's charge and drawn wheels belong to the attempt, everything else to
// each run. Calibrating, driving and recording for the gap workflow do not share their luck.
enum class Purpose : std::uint8_t { calibrate, drive, learn };
RobotTrial trial_of(const EvaluationPlan& plan, std::uint64_t number, Purpose purpose);

CalibratedModels calibrate(const EvaluationPlan& plan, std::uint64_t number);

// In the order of `candidates`; nothing for one that was left out.
using AttemptOutcome = std::array<std::optional<DriveOutcome>, candidates.size()>;

// Depends on nothing but its arguments. From the plan's seed and the attempt's number come the battery's
// charge, where the robot is put down, how its wheels stand, the phase of its clocks, its counters, and all
// noise; each drive begins with fresh ones of all but charge.
AttemptOutcome run_attempt(const EvaluationPlan& plan, std::uint64_t number);

}  // namespace wheelwright::tools
