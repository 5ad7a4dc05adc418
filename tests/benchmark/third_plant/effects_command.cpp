// Effects between the wire and the motor's current: firmware, bridge, winding, supply.
#include <algorithm>

#include "tests/benchmark/plants/text.hpp"
#include "tests/benchmark/third_plant/effects.hpp"

namespace plants::third {

namespace {

using enum Sensing;
using enum Style;

std::string dead_zone(Setting& setting) {
  FirmwareSpec& firmware = setting.robot.firmware;
  firmware.dead_band_m_s = setting.sized(0.018, 0.022, 0.05, 0.06);
  setting.habits.slow_share = 0.5;
  setting.habits.slow_m_s = (setting.large ? 1.9 : 2.5) * firmware.dead_band_m_s;
  firmware.dead_band_rescales = setting.large && setting.alone && setting.random.chance(0.5);
  return "firmware drops wheel commands below " + millimetres(firmware.dead_band_m_s) + "/s" +
         (firmware.dead_band_rescales ? " and rescales the span above it" : "");
}

std::string saturation(Setting& setting) {
  MotorSpec& motor = setting.robot.motor;
  const double top_m_s = setting.robot.fastest_m_s * setting.sized(0.91, 0.94, 0.62, 0.7);
  (setting.large ? motor.clamp_v : motor.knee_v) = top_m_s * motor.volts_per_m_s;
  return (setting.large ? "flat battery clamps the motor voltage at what gives "
                        : "driver output flattens smoothly (10th power law) near ") +
         millimetres(top_m_s) + "/s; the largest command is " + millimetres(setting.robot.fastest_m_s) + "/s";
}

std::string rate_limit(Setting& setting) {
  const double acceleration_m_s2 = setting.sized(2.0, 2.5, 0.45, 0.65);
  if (setting.large) {
    setting.robot.firmware.ramp_m_s2 = acceleration_m_s2;
    return "firmware ramps each wheel command at no more than " + fixed(acceleration_m_s2, 2) + " m/s^2";
  }
  setting.robot.motor.force_limit_n = acceleration_m_s2 * setting.robot.rim_mass_kg;
  return "motor current limit leaves " + fixed(acceleration_m_s2, 2) + " m/s^2 of acceleration";
}

std::string command_quantization(Setting& setting) {
  FirmwareSpec& firmware = setting.robot.firmware;
  firmware.command_step_m_s = setting.sized(0.016, 0.02, 0.035, 0.045);
  if (setting.large && setting.random.chance(0.5)) firmware.rounding = Rounding::towards_zero;
  setting.habits.slow_share = 0.35;
  setting.habits.slow_m_s = 0.12;
  double& metres_per_tick = setting.robot.encoder.metres_per_tick;
  if (setting.alone) metres_per_tick = std::min(metres_per_tick, 5.0e-4);
  return "integer arithmetic in firmware: commands in steps of " + millimetres(firmware.command_step_m_s, 1) +
         "/s, " + (firmware.rounding == Rounding::nearest ? "rounded" : "truncated");
}

std::string transport_delay(Setting& setting) {
  const double added_s = setting.sized(0.12, 0.16, 0.3, 0.4);
  const double board_s = setting.robot.firmware.delay_s;
  setting.robot.firmware.delay_s += added_s;
  return "radio link adds " + fixed(1000.0 * added_s, 0) + " ms of pure delay to the " +
         fixed(1000.0 * board_s, 0) + " ms of the board";
}

std::string gain_curve(Setting& setting) {
  if (setting.large) {
    MotorSpec& motor = setting.robot.motor;
    motor.gain_at_rest = 1.1;
    motor.gain_drop = setting.random.uniform(0.22, 0.27);
    return "PWM stage with slow decay: gain " + fixed(motor.gain_at_rest, 2) + " at small commands, " +
           fixed(motor.gain_at_rest - motor.gain_drop, 2) + " at full";
  }
  const double share = setting.random.uniform(0.07, 0.09);
  setting.robot.quadratic_drag_n_s2_m2 = setting.force_n(share) / setting.robot.fastest_m_s;
  return "drag with the square of speed, " + per_cent(share) + " lost at full speed";
}

std::string direction_gain(Setting& setting) {
  const double advance = setting.sized(0.025, 0.032, 0.08, 0.1);
  setting.robot.motor.brush_advance = advance;
  return "brushes set for forward running: back-EMF constant " + per_cent(advance, 1) +
         " smaller forwards and larger in reverse";
}

std::string asymmetric_response(Setting& setting) {
  const double added = setting.sized(0.4, 0.5, 2.5, 3.2);
  setting.robot.motor.braking_resistance = added;
  return "bridge brakes through a diode path: resistance of the winding circuit times " +
         fixed(1.0 + added, 1) + " while the motor brakes";
}

std::string voltage_sag(Setting& setting) {
  SupplySpec& supply = setting.robot.supply;
  setting.sensors.battery = true;
  supply.regulated = false;
  supply.open_circuit_v = 12.5;
  supply.internal_ohm = 0.15;
  supply.auxiliary_a = setting.large ? 3.0 : 1.2;
  supply.drop_in_run_v = setting.large ? 0.9 : 0.3;
  supply.drop_per_run_v = setting.large ? 0.35 : 0.15;
  return "unregulated PWM from a battery of " + fixed(supply.internal_ohm, 2) + " ohm; another consumer of " +
         fixed(supply.auxiliary_a, 1) + " A on and off, " + fixed(supply.drop_in_run_v, 2) +
         " V down in a run, " + fixed(supply.drop_per_run_v, 2) + " V from run to run";
}

}  // namespace

std::vector<Effect> command_effects() {
  return {
      {"dead_zone",
       dead_zone,
       {ticks, slow_fast_mixture, Loop::open, "coulomb_friction"},
       {ticks_and_poses, random_steps, Loop::open, "coulomb_friction"}},
      {"saturation",
       saturation,
       {ticks, random_steps, Loop::open, "gain_curve"},
       {poses, joystick, Loop::open}},
      {"rate_limit",
       rate_limit,
       {ticks, random_steps, Loop::closed},
       {ticks_and_poses, go_and_turn, Loop::closed},
       0.0,
       Response::quick},
      {"command_quantization",
       command_quantization,
       {ticks, random_steps},
       {ticks, joystick, Loop::any, "coulomb_friction"}},
      {"transport_delay", transport_delay, {ticks, random_steps}, {poses, random_steps}, 20.0},
      {"gain_curve",
       gain_curve,
       {ticks_and_ends, slow_fast_mixture, Loop::open},
       {poses, random_steps, Loop::open}},
      {"direction_gain", direction_gain, {ticks, go_and_turn, Loop::open}, {poses, joystick, Loop::open}},
      {"asymmetric_response",
       asymmetric_response,
       {ticks, random_steps, Loop::open},
       {ticks_and_poses, random_steps, Loop::open},
       0.0,
       Response::middling},
      {"voltage_sag",
       voltage_sag,
       {ticks, random_steps, Loop::open, "gain_drift"},
       {ticks_and_poses, slow_fast_mixture, Loop::open, "gain_drift"}},
  };
}

}  // namespace plants::third
