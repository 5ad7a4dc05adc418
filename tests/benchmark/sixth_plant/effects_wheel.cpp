// Wheels and tyres.
#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_wheel_eccentricity(double size, const Robot& /*robot*/, const Details& details) {
  return std::string("the ") + (details.heads() ? "left" : "right") + " wheel sits off its centre by " +
         percent(size, 1) + " % of its radius";
}

std::string how_wheel_scale_mismatch(double size, const Robot& /*robot*/, const Details& details) {
  return "the right tyre is " + signed_fixed(size * 100 * details.sign, 2) +
         " % larger than the left, log says equal";
}

std::string how_effective_track(double size, const Robot& /*robot*/, const Details& details) {
  return "the tyres bear at a distance " + signed_fixed(size * 100 * details.sign, 2) +
         " % off the log's wheel base";
}

std::string how_distance_scale(double size, const Robot& /*robot*/, const Details& details) {
  return "both tyres are " + signed_fixed(size * 100 * details.sign, 2) + " % larger than the log says";
}

std::string how_acceleration_slip(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "smooth floor: a tyre holds no more than " + percent(1 - size, 0) + " % of the force of a full step";
}

}  // namespace

std::vector<EffectEntry> wheel_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::wheel_eccentricity,
       "wheel_eccentricity",
       0.01,
       0.12,
       {eights, squares, teleoperation},
       {ticks_and_poses},
       how_wheel_eccentricity,
       "",
       0.4},
      {Effect::wheel_scale_mismatch,
       "wheel_scale_mismatch",
       0.003,
       0.1,
       {squares, eights, teleoperation, goals},
       {ticks_and_poses},
       how_wheel_scale_mismatch,
       "yaw_bias"},
      {Effect::effective_track,
       "effective_track",
       0.006,
       0.2,
       {squares, eights, teleoperation, goals},
       {ticks_and_poses},
       how_effective_track,
       "turn_scrub"},
      {Effect::distance_scale,
       "distance_scale",
       0.003,
       0.1,
       {squares, eights, teleoperation, goals},
       {ticks_and_poses},
       how_distance_scale},
      {Effect::acceleration_slip,
       "acceleration_slip",
       0.1,
       0.95,
       {steps, teleoperation, squares},
       {ticks_and_poses},
       how_acceleration_slip,
       "",
       0.7},
  };
}

}  // namespace plants::sixth
