// Everything that a robot knows of itself: what a model file holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/identification/fir_fit.hpp"
#include "model/linear_model.hpp"
#include "model/pose.hpp"

namespace wheelwright {

// Result of turning in place (PAPER.md eq. 13): metres that a wheel rolls per encoder tick.
struct EncoderScale {
  WheelPair metres_per_tick;
  double ticks_per_turn = 0.0;           // of one wheel, in one full turn of the robot
  double relative_standard_error = 0.0;  // of metres per tick
};

struct RobotModel {
  std::string robot;                // as the configuration names it
  std::string created;              // date and time, ISO 8601, as the caller read it from the clock
  std::vector<std::string> source;  // logs or manoeuvre that it was made from
  std::optional<EncoderScale> encoder_scale;
  LinearModel core;                  // holds the wheel base and the period
  std::optional<WheelFit> left_fit;  // how well the core is known
  std::optional<WheelFit> right_fit;
};

}  // namespace wheelwright
