// Without a name: between commands and motors.
#include <algorithm>

#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_supply_hiccup(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "supply_hiccup: a weak converter droops for 0.4 s after either motor draws much, both wheels lose "
         "up to " +
         percent(std::min(0.6, size), 0) + " %";
}

std::string how_turn_accel_clip(double size, const Robot& robot, const Details& /*details*/) {
  return "turn_accel_clip: the firmware limits acceleration to " + fixed(robot.top_m_s / size, 3) +
         " m/s2, only while the commands differ much";
}

std::string how_gear_hysteresis(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "gear_hysteresis: above 0.6 of full duty the gain falls " + percent(size, 1) +
         " %, and comes back below 0.35";
}

std::string how_mast_sway(double size, const Robot& /*robot*/, const Details& details) {
  return "mast_sway: the marker is on a mast that sways at " + fixed(details.mast_hz(), 2) + " Hz, " +
         fixed(size, 2) + " of its sway";
}

std::string how_link_stalls(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "link_stalls: the link freezes for about " + fixed(size, 2) +
         " s now and then, the last command is held";
}

std::string how_chipped_tooth(double size, const Robot& robot, const Details& /*details*/) {
  return "chipped_tooth: a gear of the left wheel brakes by " + percent(size, 0) +
         " % of full torque once every " + fixed(robot.gear_turns, 2) + " wheel turns";
}

}  // namespace

std::vector<EffectEntry> outside_command_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::supply_hiccup,
       "supply_hiccup",
       0.05,
       1.5,
       {steps, teleoperation, squares},
       {ticks, ticks_and_poses},
       how_supply_hiccup},
      {Effect::turn_accel_clip,
       "turn_accel_clip",
       0.05,
       2.5,
       {teleoperation, squares, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second},
       how_turn_accel_clip},
      {Effect::gear_hysteresis,
       "gear_hysteresis",
       0.03,
       0.4,
       {steps, teleoperation, creep},
       {ticks, ticks_and_poses},
       how_gear_hysteresis},
      {Effect::mast_sway,
       "mast_sway",
       0.1,
       3,
       {steps, teleoperation, squares},
       {ticks_and_poses},
       how_mast_sway,
       "",
       0.8},
      {Effect::link_stalls,
       "link_stalls",
       0.1,
       1.2,
       {teleoperation, goals, steps},
       {ticks, ticks_and_poses},
       how_link_stalls},
      {Effect::chipped_tooth,
       "chipped_tooth",
       0.03,
       1.0,
       {eights, squares, teleoperation},
       {ticks, ticks_and_poses},
       how_chipped_tooth,
       "",
       0.5},
  };
}

}  // namespace plants::sixth
