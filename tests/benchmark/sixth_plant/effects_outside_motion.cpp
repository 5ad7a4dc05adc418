// Without a name: of the motion and its measurement.
#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_pid_windup(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "pid_windup: an integrator without guard and a torque limit of " + percent(1 - size, 0) + " %";
}

std::string how_oscillating_fan(double size, const Robot& robot, const Details& /*details*/) {
  return "oscillating_fan: a fan pushes to and fro along the room's x with period 7 s, " +
         fixed(size * robot.top_m_s, 4) + " m/s";
}

std::string how_thermal_cutback(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "thermal_cutback: the left driver gets hot, loses " + percent(size, 1) + " % until it is cool";
}

std::string how_stamp_sawtooth(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "stamp_sawtooth: measurements are old by 0 to " + fixed(size * 1e3, 0) + " ms, sawtooth of 9 s";
}

std::string how_payload_flips(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "payload_flips: a load slides to the side of the last sharp turn and brakes that wheel by " +
         percent(size, 1) + " %";
}

std::string how_driver_sleep(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "driver_sleep: after 0.6 s at rest the driver sleeps and needs " + fixed(size, 2) + " s to wake";
}

}  // namespace

std::vector<EffectEntry> outside_motion_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::pid_windup,
       "pid_windup",
       0.1,
       0.85,
       {steps, teleoperation, squares},
       {ticks, ticks_and_poses},
       how_pid_windup},
      {Effect::oscillating_fan,
       "oscillating_fan",
       0.005,
       0.3,
       {squares, eights, teleoperation},
       {ticks_and_poses},
       how_oscillating_fan},
      {Effect::thermal_cutback,
       "thermal_cutback",
       0.03,
       0.5,
       {teleoperation, squares, eights},
       {ticks, ticks_and_poses},
       how_thermal_cutback},
      {Effect::stamp_sawtooth,
       "stamp_sawtooth",
       0.008,
       0.5,
       {teleoperation, squares, steps},
       {ticks, ticks_and_poses},
       how_stamp_sawtooth},
      {Effect::payload_flips,
       "payload_flips",
       0.01,
       0.4,
       {teleoperation, squares, goals},
       {ticks, ticks_and_poses},
       how_payload_flips},
      {Effect::driver_sleep,
       "driver_sleep",
       0.08,
       0.9,
       {steps, squares, teleoperation},
       {ticks, ticks_and_poses},
       how_driver_sleep},
  };
}

}  // namespace plants::sixth
