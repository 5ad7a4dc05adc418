// Where and when the robot is measured.
#include <cmath>

#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_lever_arm(double size, const Robot& /*robot*/, const Details& details) {
  return "the marker sits (" + signed_fixed(size * std::cos(details.angle_rad), 4) + ", " +
         signed_fixed(size * std::sin(details.angle_rad), 4) + ") m off the axle's middle";
}

std::string how_encoder_dropout(double size, const Robot& /*robot*/, const Details& details) {
  return "counting stops for short whiles, " + percent(size, 1) + " % of the time (" +
         (details.heads() ? "left" : "both") + ")";
}

}  // namespace

std::vector<EffectEntry> measurement_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::lever_arm,
       "lever_arm",
       0.004,
       0.10,
       {eights, squares, teleoperation, goals},
       {ticks_and_poses, poses},
       how_lever_arm,
       "",
       2.0},
      {Effect::encoder_dropout,
       "encoder_dropout",
       0.003,
       0.15,
       {teleoperation, squares, eights, goals},
       {ticks, ticks_and_poses},
       how_encoder_dropout,
       "",
       0.6},
  };
}

}  // namespace plants::sixth
