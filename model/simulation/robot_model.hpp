// Everything that a robot knows of itself: what a model file holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/geometry/pose.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/wheel_fit.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright {

// Result of turning in place (eq. 13 of the source paper): metres that a wheel rolls per encoder tick.
struct EncoderScale {
  WheelPair metres_per_tick;
  double ticks_per_turn = 0.0;           // of one wheel, in one full turn of the robot
  double relative_standard_error = 0.0;  // of metres per tick
};

// How well a parameter of an effect is known: 95 % interval.
struct ParameterInterval {
  double lower = 0.0;
  double upper = 0.0;
};

inline double standard_deviation(const ParameterInterval& interval) {
  return (interval.upper - interval.lower) / (2.0 * deviations_in_ci95);
}

// An effect that was found missing and added, and why it is believed.
struct AddedEffect {
  EffectSetting setting;
  std::vector<ParameterInterval> intervals;  // one per parameter, or none where it was not estimated
  std::vector<std::string> source;           // logs that it was found in
  std::string created;                       // date and time, ISO 8601
  std::optional<double> heldout_gain_nats;   // of log likelihood, on runs that were not used to fit it
  std::optional<double> p_value;
};

struct RobotModel {
  std::string robot;                // as the configuration names it
  std::string created;              // date and time, ISO 8601, as the caller read it from the clock
  std::vector<std::string> source;  // logs or manoeuvre that it was made from
  std::optional<EncoderScale> encoder_scale;
  LinearModel linear_part;           // holds the wheel base and the period
  std::optional<WheelFit> left_fit;  // how well the linear part is known
  std::optional<WheelFit> right_fit;
  std::vector<AddedEffect> effects;  // in the order in which they act
};

// The effects alone, as a simulation takes them.
std::vector<EffectSetting> effect_settings(const RobotModel& model);

}  // namespace wheelwright
