// Where a search begins: a short linear part, and the effects that the robot's model is known to have.
#pragma once

#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/fit/trial_model.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

std::vector<TrialEffect> trial_effects_of(const RobotModel& model);

// Roughly fitted; `given` may be null. The noise of the problem is forgotten.
TrialModel search_start(FitProblem& train, const RobotModel* given);

}  // namespace wheelwright::gap
