// Trial models as models of the robot: what a simulation takes, and what is written to a model file.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/gap/conclusion/finding.hpp"
#include "model/gap/fit/trial_model.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

struct ModelOrigin {
  const RobotModel* given = nullptr;  // whose gap is looked for: its name and its encoder scale stay
  std::vector<std::string> logs;      // that the trial model was fitted to
};

// Its linear part alone.
RobotModel linear_model_of(const TrialModel& trial, const ModelOrigin& origin);

// With its effects, in the order in which they act.
RobotModel whole_model_of(const TrialModel& trial, const ModelOrigin& origin);

// The same, each effect with the evidence of its finding; what the data gate found is put in front, and an
// effect that is not among the findings stays out.
RobotModel found_model_of(const TrialModel& trial, std::span<const Finding> found, const ModelOrigin& origin);

}  // namespace wheelwright::gap
