// What firmware, bridge and radio make of commands.
#include "tests/benchmark/sixth_plant/effects.hpp"
#include "tests/benchmark/sixth_plant/signed_text.hpp"

namespace plants::sixth {

namespace {

std::string how_dead_zone(double size, const Robot& robot, const Details& /*details*/) {
  return "the H bridge passes no pulse shorter than the duty of " + fixed(size * robot.top_m_s, 4) + " m/s";
}

std::string how_saturation(double size, const Robot& robot, const Details& /*details*/) {
  return "the duty register ends at " + fixed((1 - size) * robot.top_m_s, 4) + " m/s";
}

std::string how_rate_limit(double size, const Robot& robot, const Details& /*details*/) {
  return "the firmware ramps the duty by no more than " + fixed(robot.top_m_s / size, 3) + " m/s2";
}

std::string how_command_quantization(double size, const Robot& robot, const Details& /*details*/) {
  return "the link carries speeds in steps of " + fixed(size * robot.top_m_s, 4) + " m/s";
}

std::string how_transport_delay(double size, const Robot& /*robot*/, const Details& /*details*/) {
  return "the radio's buffer holds commands for " + fixed(size * 1e3, 1) + " ms more";
}

}  // namespace

std::vector<EffectEntry> command_effects() {
  using enum Programme;
  using enum Channels;
  return {
      {Effect::dead_zone,
       "dead_zone",
       0.03,
       0.25,
       {creep, teleoperation, steps},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_dead_zone,
       "stiction coulomb_friction",
       0.8},
      {Effect::saturation,
       "saturation",
       0.04,
       0.6,
       {steps, teleoperation, eights, squares},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_saturation},
      {Effect::rate_limit,
       "rate_limit",
       0.04,
       2.5,
       {steps, teleoperation, squares},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_rate_limit},
      {Effect::command_quantization,
       "command_quantization",
       0.03,
       0.5,
       {teleoperation, goals, creep},
       {ticks, ticks_and_poses, ticks_and_poses_each_second},
       how_command_quantization,
       "",
       0.6},
      {Effect::transport_delay,
       "transport_delay",
       0.05,
       0.4,
       {steps, teleoperation, goals},
       {ticks, ticks_and_poses, ticks_and_poses_each_second, poses},
       how_transport_delay},
  };
}

}  // namespace plants::sixth
