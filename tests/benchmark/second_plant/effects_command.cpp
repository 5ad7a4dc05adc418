// Effects between the wire and the motor: firmware, bridge, supply.
#include "tests/benchmark/second_plant/effects.hpp"

namespace plants::second {

namespace {

using enum Sensing;

void dead_zone(RobotSpec& robot, double level, Random&) {
  robot.firmware.minimum_command_m_s = sized(0.025, 0.09, level);
}

void saturation(RobotSpec& robot, double level, Random&) {
  const double top_m_s = sized(0.85, 0.55, level) * robot.fastest_m_s;
  robot.motor.supply_v = top_m_s * robot.controller.feedforward_v_s_m;
  robot.motor.supply_resistance_ohm = 0.1 * robot.motor.resistance_ohm;
}

void limit_by_current(RobotSpec& robot, double acceleration_m_s2) {
  // A drag near the limit would make the limit depend on the speed.
  for (TyreSpec& tyre : robot.tyre) tyre.hub_drag_n_s_m *= 0.1;
  const double moved_kg = robot.motor.rotor_mass_kg + 0.5 * robot.body.mass_kg;
  robot.motor.current_limit_a = moved_kg * acceleration_m_s2 / robot.motor.emf_v_s_m;
}

void rate_limit(RobotSpec& robot, double level, Random&) {
  const double acceleration_m_s2 = sized(1.3, 0.35, level);
  if (level < large_level)
    robot.firmware.ramp_m_s2 = acceleration_m_s2;
  else
    limit_by_current(robot, acceleration_m_s2);
}

void command_quantization(RobotSpec& robot, double level, Random&) {
  robot.firmware.command_step_m_s = sized(0.014, 0.045, level);
}

void transport_delay(RobotSpec& robot, double level, Random&) {
  robot.firmware.delay_s += sized(0.12, 0.35, level);
}

void bend_pwm(RobotSpec& robot, double bend) {
  constexpr double typical_duty = 0.12;
  robot.motor.pwm_bend = bend;
  robot.controller.feedforward_v_s_m *= (1.0 + bend * typical_duty) / (1.0 + bend);
}

void gain_curve(RobotSpec& robot, double level, Random&) {
  constexpr double small_share = 0.11;
  constexpr double medium_share = 0.17;
  const double share = level > small_level ? medium_share : small_share;
  if (level < large_level)
    for (TyreSpec& tyre : robot.tyre)
      tyre.quadratic_drag_n_s2_m2 = share * robot.drive_stiffness_n_s_m() / robot.fastest_m_s;
  else
    bend_pwm(robot, 2.0);
}

void direction_gain(RobotSpec& robot, double level, Random& random) {
  robot.motor.brush_advance = random.sign() * sized(0.02, 0.07, level);
}

void asymmetric_response(RobotSpec& robot, double level, Random&) {
  robot.motor.braking_resistance = sized(0.6, 3.0, level);
}

void voltage_sag(RobotSpec& robot, double level, Random&) {
  BatterySpec& battery = robot.battery;
  battery.compensated = false;
  battery.full_v = 16.0;
  battery.drop_per_run_v = sized(0.08, 0.30, level);
  battery.drop_per_s_v = sized(0.002, 0.006, level);
  battery.internal_ohm = sized(0.3, 0.6, level);
  battery.auxiliary_a = sized(1.6, 4.0, level);
  battery.auxiliary_hold_s = 7.0;
}

void gain_drift(RobotSpec& robot, double level, Random& random) {
  constexpr double kRise_k = 30.0;
  GreaseSpec& grease = robot.grease;
  const double share = sized(0.09, 0.28, level);
  grease.cold_drag_n_s_m = share * robot.drive_stiffness_n_s_m();
  const double typical_loss_w = 0.1 * grease.cold_drag_n_s_m * robot.fastest_m_s * robot.fastest_m_s;
  grease.warming_k_w = kRise_k / typical_loss_w;
  grease.time_constant_s = random.uniform(22.0, 38.0);
}

}  // namespace

std::vector<Effect> command_effects() {
  return {
      {"dead_zone",
       Drive::any,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks, poses},
       true,
       dead_zone,
       "firmware switches the motor off below a smallest command"},
      {"saturation",
       Drive::soft,
       {ticks, ticks_and_ends},
       {poses, ticks_and_poses},
       false,
       saturation,
       "supply voltage with source resistance runs out against the back-EMF"},
      {"rate_limit",
       Drive::stiff,
       {ticks, ticks_and_poses},
       {ticks, poses},
       true,
       rate_limit,
       "small: ramp in the firmware; large: current limiter under a PI loop with anti-windup"},
      {"command_quantization",
       Drive::any,
       {ticks, ticks_and_ends},
       {ticks_and_poses, ticks},
       false,
       command_quantization,
       "firmware keeps the speed in a coarse integer register (rounding)"},
      {"transport_delay",
       Drive::any,
       {ticks, poses},
       {ticks_and_poses, ticks},
       true,
       transport_delay,
       "packets wait in a radio buffer: 0.12 s or 0.35 s on top of 10-60 ms"},
      {"gain_curve",
       Drive::soft,
       {ticks, ticks_and_poses},
       {poses, ticks},
       true,
       gain_curve,
       "small: fan-like load that grows with speed squared; large: PWM in discontinuous conduction"},
      {"direction_gain",
       Drive::soft,
       {ticks_and_ends, ticks},
       {ticks, poses},
       false,
       direction_gain,
       "brush advance: motor constant differs with the sense of rotation"},
      {"asymmetric_response",
       Drive::soft,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks},
       true,
       asymmetric_response,
       "braking current flows through a larger resistance than driving current"},
      {"voltage_sag",
       Drive::soft,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks},
       false,
       voltage_sag,
       "uncompensated PWM from a battery with internal resistance, another consumer switching, log has "
       "volts"},
      {"gain_drift",
       Drive::soft,
       {ticks, ticks_and_poses},
       {poses, ticks},
       false,
       gain_drift,
       "gear grease thins as churning and copper loss warm it, every run from cold"},
  };
}

}  // namespace plants::second
