// The models that a robot may have as well as the one that was found: each is that model with one uncertain
// parameter moved by one standard deviation.
#pragma once

#include <vector>

#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Parameters whose uncertainty a model file states:
//   - the gain of each wheel (WheelFit::gain_standard_error), from either command where it depends on both;
//   of a
//     model without effects also what a gain is off at other speeds than those of its calibration,
//   - the encoder scale, which is the unit of all speeds: both gains at once,
//   - each parameter of an effect that has a 95 % interval. The farther end of the interval counts, as a
//   normal
//     distribution has it (1.96 standard deviations), within what is physically possible.
// They are taken as independent of each other. Empty where the model states none.
std::vector<RobotModel> moved_models(const RobotModel& model);

}  // namespace wheelwright
