// What acts on the body.
#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_turn_speed_loss(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the castor scrubs in turns: " + fixed(size, 4) + " m/s of speed lost per rad/s";
}

std::string how_turn_scrub(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "wide soft tyres scrub: torque grows with the square of the turn rate, about " + percent(size, 1) +
         " % is lost at 3 rad/s";
}

std::string how_yaw_bias(double size, const Robot& /*robot*/, const Details& details) {
  return "a side brush that runs with the wheels pulls by about " + signed_fixed(size * details.sign, 4) +
         " rad/s";
}

std::string how_floor_slope(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the floor slopes by " + fixed(size, 2) + " degrees";
}

std::string how_surface_patch(double size, const Robot& /*robot*/, const Details& details) {
  return "a carpet of " + fixed(2 * details.patch_half_m, 2) + " m across brakes a wheel on it by " +
         percent(size, 1) + " %";
}

std::string how_caster_kick(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the castor's fork swivels after reversals and pushes with about " + fixed(size, 3) +
         " rad/s at most";
}

}  // namespace

std::vector<EffectEntry> floor_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::turn_speed_loss,
       "turn_speed_loss",
       0.001,
       0.08,
       {eights, teleoperation, goals},
       {ticks, ticks_and_poses, poses},
       how_turn_speed_loss},
      {Effect::turn_scrub,
       "turn_scrub",
       0.01,
       0.5,
       {eights, teleoperation, squares, goals},
       {ticks_and_poses, poses},
       how_turn_scrub,
       "effective_track"},
      {Effect::yaw_bias,
       "yaw_bias",
       0.004,
       0.2,
       {squares, teleoperation, goals, steps},
       {ticks_and_poses, poses},
       how_yaw_bias,
       "wheel_scale_mismatch"},
      {Effect::floor_slope,
       "floor_slope",
       0.3,
       12,
       {squares, eights, teleoperation, goals},
       {ticks_and_poses, poses},
       how_floor_slope},
      {Effect::surface_patch,
       "surface_patch",
       0.02,
       0.6,
       {squares, eights, goals, teleoperation},
       {ticks_and_poses, poses},
       how_surface_patch,
       "",
       0.8},
      {Effect::caster_kick,
       "caster_kick",
       0.03,
       2.0,
       {steps, teleoperation},
       {ticks_and_poses, poses},
       how_caster_kick,
       "",
       0.7},
  };
}

}  // namespace plants::sixth
