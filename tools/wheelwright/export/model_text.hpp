// A model in the words of another program.
#pragma once

#include <string>
#include <vector>

#include "model/simulation/robot_model.hpp"

namespace wheelwright::tools {

// An effect of the model that the format has no place for.
struct Unsaid {
  std::string effect;
  std::string reason;
};

struct ModelText {
  std::string text;  // with what is unsaid in a comment at its beginning
  std::vector<Unsaid> unsaid;
};

// No parameter of a robot is known better.
std::string nine_digits(double value);

// "coulomb_friction", or "surface_patch (wheel_round)".
std::string full_name(const EffectSetting& setting);

// "speed_loss 0.012 m/s (95 % interval 0.01 to 0.014)", one parameter after the other, and when it was found.
std::string with_intervals(const AddedEffect& effect);

// Of which robot, made when.
std::string origin_of(const RobotModel& model);

}  // namespace wheelwright::tools
