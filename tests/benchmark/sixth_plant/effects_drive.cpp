// Motors and gears.
#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_coulomb_friction(double size, const Robot& robot, const Details& /*details*/) {
  return "dry gear boxes take " + fixed(size * robot.top_m_s, 4) + " m/s of speed (" +
         fixed(size * robot.top_m_s * robot.yield_n_s_m(), 2) + " N at the rim)";
}

std::string how_stiction(double size, const Robot& robot, const Details& /*details*/) {
  return "dried grease: a wheel at rest needs a command of " + fixed(size * robot.top_m_s, 4) +
         " m/s to break away, and is free when it rolls";
}

std::string how_gain_curve(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "slow-decay PWM: mean voltage is bent, the gain is " + fixed(2 * size * 100, 1) +
         " % different between low and full duty";
}

std::string how_direction_gain(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "brushes set ahead: reverse is " + percent(size, 1) + " % slower than forward";
}

std::string how_asymmetric_response(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "braking current freewheels: braking torque is only " + percent(1 - size, 0) +
         " % of driving torque";
}

std::string how_voltage_sag(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the battery is not regulated: it loses " + percent(size, 1) + " % in a run, and has a resistance";
}

std::string how_gain_drift(double size, const Robot& /*robot*/, const Details& details) {
  return std::string(details.heads() ? "cold grease takes " : "the bridge's reference warms: speed falls ") +
         percent(size, 1) + (details.heads() ? " % of the speed, and warms in " : " % in ") +
         fixed(details.warming_s, 0) + " s";
}

std::string how_backlash(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the gears have a gap of " + fixed(size * 1e3, 2) + " mm at the rim";
}

}  // namespace

std::vector<EffectEntry> drive_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::coulomb_friction,
       "coulomb_friction",
       0.008,
       0.25,
       {creep, steps, teleoperation, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_coulomb_friction,
       "dead_zone stiction"},
      {Effect::stiction,
       "stiction",
       0.03,
       0.45,
       {creep, goals, steps},
       {ticks, ticks_and_poses, ticks_and_poses_each_second},
       how_stiction,
       "dead_zone coulomb_friction",
       0.7},
      {Effect::gain_curve,
       "gain_curve",
       0.02,
       0.5,
       {steps, teleoperation, creep, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_gain_curve},
      {Effect::direction_gain,
       "direction_gain",
       0.006,
       0.3,
       {steps, teleoperation, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_direction_gain},
      {Effect::asymmetric_response,
       "asymmetric_response",
       0.1,
       0.92,
       {steps, teleoperation, squares},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_asymmetric_response,
       "rate_limit"},
      {Effect::voltage_sag,
       "voltage_sag",
       0.015,
       0.3,
       {teleoperation, eights, squares, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_voltage_sag,
       "gain_drift"},
      {Effect::gain_drift,
       "gain_drift",
       0.015,
       0.3,
       {teleoperation, eights, squares, steps},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_gain_drift,
       "voltage_sag"},
      {Effect::backlash,
       "backlash",
       0.001,
       0.012,
       {steps, teleoperation, creep},
       {ticks, ticks_and_poses, ticks_and_poses_each_second},
       how_backlash,
       "dead_zone",
       0.6},
  };
}

}  // namespace plants::sixth
