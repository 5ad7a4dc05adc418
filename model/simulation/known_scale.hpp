// The encoder scale that a model has to have to be compared with counts.
#pragma once

#include <stdexcept>

#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Metres per tick. Throws std::invalid_argument where the model has no encoder scale.
inline WheelPair known_scale(const RobotModel& model) {
  if (!model.encoder_scale) {
    throw std::invalid_argument("the model has no encoder scale: calibrate it, or give metres per tick");
  }
  return model.encoder_scale->metres_per_tick;
}

}  // namespace wheelwright
