// Effects from the rotor to the tyre, and of the encoder.
#include <algorithm>

#include "tests/benchmark/plants/text.hpp"
#include "tests/benchmark/third_plant/effects.hpp"

namespace plants::third {

namespace {

using enum Sensing;
using enum Style;

std::string closed_loop_friction(Setting& setting, double lost_m_s) {
  ControllerSpec& controller = setting.robot.controller;
  const double stiffening = 1.0 + controller.proportional;
  const double recovery_s = setting.random.uniform(3.5, 5.0);
  controller.integral_1_s = stiffening / recovery_s;
  setting.robot.friction.coulomb_n = setting.force_n(lost_m_s * stiffening);
  return "LuGre dry friction under a PI loop: " + millimetres(lost_m_s) +
         "/s lost at first, the integral takes it back in about " + fixed(recovery_s, 1) + " s";
}

std::string coulomb_friction(Setting& setting) {
  FrictionSpec& friction = setting.robot.friction;
  setting.habits.slow_share = std::min(setting.habits.slow_share, 0.15);
  const double lost_m_s = setting.sized(0.0055, 0.0065, 0.022, 0.028);
  if (!setting.large) {
    friction.coulomb_n = setting.force_n(lost_m_s);
    friction.regularised_m_s = 0.004;
    return "dry friction in the gear (regularised, 4 mm/s), open loop: " + millimetres(lost_m_s, 1) +
           "/s lost";
  }
  friction.bristle_travel_m = 3.0e-4;
  if (setting.robot.controller.closed_loop) return closed_loop_friction(setting, lost_m_s);
  friction.coulomb_n = setting.force_n(lost_m_s);
  return "LuGre dry friction, open loop: " + millimetres(lost_m_s) + "/s lost";
}

std::string stiction(Setting& setting) {
  FrictionSpec& friction = setting.robot.friction;
  const double breakaway_m_s = setting.sized(0.025, 0.029, 0.065, 0.075);
  friction.breakaway_n = setting.force_n(breakaway_m_s);
  friction.coulomb_n = 0.1 * friction.breakaway_n;
  friction.stribeck_m_s = 0.006;
  setting.habits.slow_share = 0.75;
  setting.habits.slow_m_s = 2.0 * breakaway_m_s;
  return "LuGre friction: to break away costs " + millimetres(breakaway_m_s) + "/s of command, to move " +
         millimetres(0.1 * breakaway_m_s, 1) + "/s (Stribeck speed 6 mm/s)";
}

std::string gain_drift(Setting& setting) {
  const double lost = setting.sized(0.09, 0.105, 0.22, 0.27);
  GreaseSpec& grease = setting.robot.grease;
  grease.cold_drag_n_s_m = setting.force_n(lost);
  grease.warming_s = setting.random.uniform(28.0, 38.0);
  return "cold grease at the start of each run: " + per_cent(lost / (1.0 + lost)) +
         " of the speed lost at first, thins with " + fixed(grease.warming_s, 0) + " s";
}

std::string backlash(Setting& setting) {
  const double play_m = setting.sized(0.003, 0.0037, 0.009, 0.012);
  for (GearSpec& gear : setting.robot.gear) {
    gear.play = setting.large ? Play::operator_of_play : Play::sprung;
    gear.play_m = play_m;
  }
  return setting.large
             ? "play of " + millimetres(play_m, 1) + " at the rim between motor and wheel (play operator)"
             : "dead space of " + millimetres(play_m, 1) +
                   " at the rim with stiff teeth and a light wheel in grease";
}

std::string wheel_eccentricity(Setting& setting) {
  PerWheel<double> share{};
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel) {
    share[wheel] = setting.sized(0.045, 0.055, 0.14, 0.17);
    (setting.large ? setting.robot.tyre[wheel].eccentricity : setting.robot.gear[wheel].eccentricity) =
        share[wheel];
  }
  const std::string both = per_cent(share[left_side], 1) + " and " + per_cent(share[right_side], 1);
  return setting.large ? "wheels off centre by " + both + " of the radius, angle new each run"
                       : "final gear off centre: wheel speed ripples by " + both + " once per turn";
}

std::string wheel_scale_mismatch(Setting& setting) {
  const double size = setting.sized(0.014, 0.018, 0.045, 0.055);
  const double mismatch = size * setting.random.sign();
  setting.robot.tyre[left_side].rolling_factor *= 1.0 - 0.5 * mismatch;
  setting.robot.tyre[right_side].rolling_factor *= 1.0 + 0.5 * mismatch;
  return "tyres: the right one rolls " + per_cent(mismatch, 1) + " farther than the left for the same count";
}

std::string distance_scale(Setting& setting) {
  const double size = setting.sized(0.015, 0.019, 0.05, 0.06);
  const double farther = size * setting.random.sign();
  for (TyreSpec& tyre : setting.robot.tyre) tyre.rolling_factor *= 1.0 + farther;
  return "both tyres roll " + per_cent(farther, 1) + " farther than the count says";
}

std::string acceleration_slip(Setting& setting) {
  const double grip_m_s2 = setting.sized(2.4, 2.8, 1.4, 1.7);
  for (TyreSpec& tyre : setting.robot.tyre) tyre.grip_m_s2 = grip_m_s2;
  return "dusty floor: tyre force peaks at " + fixed(grip_m_s2, 2) +
         " m/s^2 (magic-formula law), wheels spin and slide beyond it";
}

std::string encoder_dropout(Setting& setting) {
  EncoderSpec& encoder = setting.robot.encoder;
  encoder.dropouts = setting.large ? EpisodeSpec{7, 0.2, 0.5} : EpisodeSpec{5, 0.1, 0.3};
  encoder.delivers_afterwards = !setting.large && setting.random.chance(0.5);
  return std::to_string(encoder.dropouts.per_run) + " times a run one count freezes for " +
         fixed(encoder.dropouts.shortest_s, 1) + " to " + fixed(encoder.dropouts.longest_s, 1) +
         " s, pulses " + (encoder.delivers_afterwards ? "delivered afterwards" : "lost");
}

}  // namespace

std::vector<Effect> drive_effects() {
  return {
      {"coulomb_friction",
       coulomb_friction,
       {ticks_and_poses, joystick, Loop::open, "dead_zone"},
       {ticks, random_steps, Loop::closed, "dead_zone"}},
      {"stiction",
       stiction,
       {ticks, slow_fast_mixture, Loop::open, "dead_zone"},
       {ticks, slow_fast_mixture, Loop::open, "dead_zone"}},
      {"gain_drift", gain_drift, {ticks, joystick, Loop::open}, {poses, go_and_turn, Loop::open}},
      {"backlash", backlash, {ticks, random_steps}, {ticks_and_ends, go_and_turn}},
      {"wheel_eccentricity", wheel_eccentricity, {ticks, joystick}, {ticks_and_poses, random_steps}, 20.0},
      {"wheel_scale_mismatch",
       wheel_scale_mismatch,
       {ticks_and_poses, go_and_turn},
       {ticks_and_ends, random_steps}},
      {"distance_scale", distance_scale, {ticks_and_poses, random_steps}, {ticks_and_ends, joystick}},
      {"acceleration_slip",
       acceleration_slip,
       {ticks_and_poses, random_steps, Loop::any, "rate_limit"},
       {ticks_and_poses, go_and_turn, Loop::any, "rate_limit"},
       20.0,
       Response::quick},
      {"encoder_dropout", encoder_dropout, {ticks, joystick}, {ticks_and_poses, slow_fast_mixture}},
  };
}

}  // namespace plants::third
