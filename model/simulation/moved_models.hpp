// The models that a robot may have as well as the one that was found: each is that model with one uncertain
// parameter moved by one standard deviation, up and down.
#pragma once

#include <vector>

#include "model/simulation/robot_model.hpp"

namespace wheelwright {

struct MovedModels {
  RobotModel up;
  RobotModel down;
};

// By how much the gain of a route may differ from that of its calibration, beyond the stated error: other
// speeds, another day. As a fraction, set by hand: the gains of forty ARMA calibrations scatter by 0.1 % on
// the simulated robot `default`, by 0.2 % on `table2`, and by 1.5 % on `create2`, which acts in steps.
inline constexpr double gain_discrepancy = 0.002;

// Parameters whose uncertainty a model file states, taken as independent of each other: the gain of each
// wheel (WheelFit::gain_standard_error, and gain_discrepancy), from either command where it depends on both;
// the encoder scale, which is the unit of all speeds, so that both gains move at once; and each parameter of
// an effect that has a 95 % interval, each end by itself, within what is physically possible. The mismatch
// of the wheels is left to FilterNoise::wheel_mismatch. Empty where the model states none.
std::vector<MovedModels> moved_models(const RobotModel& model);

// The effects' parameters alone, moved by that many standard deviations.
std::vector<MovedModels> moved_effects(const RobotModel& model, double deviations);

}  // namespace wheelwright
