// Which effects of a robot have to be other than those of its simulation.
//
// A size that was fitted to the runs of either is off by more than its interval says where both lack
// something that no effect has, as a speed controller, and one effect may take what two stand for. What need
// not differ, the robot's runs show: they are as likely with the simulation's effects as these are and a
// linear part that is free. From there one effect after the other becomes what was found of the robot, the
// one first that gains the most on the training runs, until the held-out runs ask for no more.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {

struct NeededDifferences {
  std::vector<std::string> effects;  // names of those that have to differ
  TrialModel model;                  // of the robot, with the simulation's effects otherwise
};

// `of_robot` is the model that was fitted to `train`. Held-out runs ask for a difference where their log
// likelihood is lower by confirming_nats without it, deflated by the residuals' autocorrelation. A delay,
// which is compared with the linear parts, and counts that were lost are of the robot alone.
NeededDifferences needed_differences(std::span<const TrialEffect> of_simulation, const TrialModel& of_robot,
                                     const FitProblem& train, const FitProblem& heldout);

}  // namespace wheelwright::gap
