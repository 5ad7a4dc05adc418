// How far encoders and model may be apart while both are sound: the figures that every test of the filter
// rests on.
#pragma once

#include "model/geometry/pose.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Lower bound of the standard error of a gain, as a fraction, set by hand: a short calibration cannot know
// how the gain drifts over the day, nor what friction makes of it at other speeds.
inline constexpr double min_gain_error = 0.004;

struct FilterNoise {
  // A poll sees counters that are between 0 and this old, each age as likely as any other; and a command
  // acts as much later. The robot refreshes its sensors and its controller on this period.
  double refresh_period_s = 1.0 / 64.0;
  WheelPair position_noise_m{0.0004, 0.0004};    // of one reading of wheel travel, standard deviation
  WheelPair drift_m_per_sqrt_s{0.0003, 0.0003};  // random walk of travel against the model
  WheelPair gain_standard_error{0.005, 0.005};   // of the model's travel, as a fraction of it
  double scale_standard_error = 0.001;           // of metres per tick, as a fraction
  double slip_m_per_sqrt_m = 0.001;              // random walk of the floor travel against the counts
  // Of the right wheel's rolling radius over the left one's, standard deviation. Neither the counts nor
  // turning in place show it, so it is set by hand.
  double wheel_mismatch = 0.0025;
};

// The figures that the calibration found; the defaults stand where it left none. A mismatch of the wheels
// that was found (effect wheel_scale_mismatch) is as uncertain as its interval says.
FilterNoise filter_noise_of(const RobotModel& model);

}  // namespace wheelwright
