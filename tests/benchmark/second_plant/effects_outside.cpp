// Structured imperfections that are none of the named effects.
#include <numbers>

#include "tests/benchmark/second_plant/effects.hpp"

namespace plants::second {

namespace {

using enum Sensing;

void loose_payload(RobotSpec& robot, double, Random& random) {
  OddForceSpec& odd = robot.odd_force;
  odd.payload_kg = 0.8 * robot.body.mass_kg;
  odd.payload_hz = random.uniform(1.2, 2.0);
  odd.payload_friction.breakaway_n = 0.8 * odd.payload_kg;
  odd.payload_friction.coulomb_n = 0.06 * odd.payload_kg;
  odd.payload_friction.stribeck_speed_m_s = 0.01;
}

void pump_pulses(RobotSpec& robot, double, Random& random) {
  robot.odd_force.pump_n = 0.03 * robot.drive_stiffness_n_s_m();
  robot.odd_force.pump_period_s = random.uniform(1.2, 2.2);
}

void gusts(RobotSpec& robot, double, Random& random) {
  robot.odd_force.gust_n = 2.0 * 0.08 * robot.drive_stiffness_n_s_m();
  robot.odd_force.gust_period_s = random.uniform(7.0, 11.0);
  robot.odd_force.gust_direction_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
}

void hunting(RobotSpec& robot, double, Random&) {
  robot.controller.hunting_v = 0.06 * robot.motor.emf_v_s_m;
  robot.controller.hunting_band_m = 0.012;
}

void stale_packets(RobotSpec& robot, double, Random& random) {
  robot.odd_command.resend_jump_m_s = 0.4 * robot.fastest_m_s;
  robot.odd_command.resend_after_s = random.uniform(0.35, 0.5);
  robot.odd_command.resend_hold_s = 0.25;
}

void seizing_wheel(RobotSpec& robot, double, Random&) {
  robot.odd_force.seizing_drag_n_s_m = 8.0 * robot.drive_stiffness_n_s_m();
  robot.odd_force.seizing_every_s = 7.0;
}

void magnet_drive(RobotSpec& robot, double, Random&) {
  robot.odd_command.magnet_memory_m_s = 0.03;
}

void two_gears(RobotSpec& robot, double, Random& random) {
  robot.odd_command.low_gear_ratio = random.uniform(0.78, 0.88);
}

}  // namespace

std::vector<Effect> outside_effects() {
  const std::vector<Sensing> ticks{Sensing::ticks};
  const std::vector<Sensing> both{ticks_and_poses};
  return {
      {"loose_payload", Drive::soft, ticks, ticks, false, loose_payload,
       "load on a sprung tray, held by friction, breaks loose above an acceleration and swings"},
      {"pump_pulses", Drive::soft, both, both, false, pump_pulses,
       "pulsing pump torque on both drives, bound to time and not to wheel angle"},
      {"gusts", Drive::soft, both, both, false, gusts, "fan that sweeps the room blows every 7-11 s"},
      {"hunting", Drive::soft, ticks, ticks, false, hunting,
       "relay position loop of the firmware hunts around the target while driving"},
      {"stale_packets", Drive::stiff, ticks, ticks, false, stale_packets,
       "after a large change of command the old command is sent once more, late, for a quarter second"},
      {"seizing_wheel", Drive::stiff, both, both, false, seizing_wheel,
       "one wheel or the other jams for half a second at random times"},
      {"magnet_drive", Drive::stiff, ticks, ticks, false, magnet_drive,
       "magnetic hysteresis of the drive: speed depends on whether the command came from above or below"},
      {"two_gears", Drive::stiff, both, both, false, two_gears,
       "gearbox swaps between two ratios at every stand-still"},
  };
}

}  // namespace plants::second
