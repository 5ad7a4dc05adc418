// Effects from the rotor to the tyre, and of the encoder.
#include "tests/benchmark/second_plant/effects.hpp"

namespace plants::second {

namespace {

using enum Sensing;

void coulomb_friction(RobotSpec& robot, double level, Random&) {
  const double friction_n = sized(0.011, 0.045, level) * robot.drive_stiffness_n_s_m();
  robot.friction.coulomb_n = friction_n;
  robot.friction.breakaway_n = friction_n;
}

void stiction(RobotSpec& robot, double level, Random&) {
  const double breakaway_n = sized(0.04, 0.09, level) * robot.drive_stiffness_n_s_m();
  robot.friction.breakaway_n = breakaway_n;
  robot.friction.coulomb_n = 0.06 * breakaway_n;
  robot.friction.stribeck_speed_m_s = 0.012;
}

void backlash(RobotSpec& robot, double level, Random&) {
  // The wheel side must not coast across the play, so the wheels get a drag that the controller knows.
  const double before_n_s_m = robot.drive_stiffness_n_s_m();
  for (TyreSpec& tyre : robot.tyre) tyre.hub_drag_n_s_m += 0.6 * before_n_s_m;
  robot.controller.feedforward_v_s_m +=
      0.6 * before_n_s_m * robot.motor.resistance_ohm / robot.motor.emf_v_s_m;
  robot.gear.lash_m = sized(0.003, 0.010, level);
}

void wheel_eccentricity(RobotSpec& robot, double level, Random&) {
  if (level < large_level) {
    robot.gear.eccentricity = sized(0.04, 0.12, level);
    return;
  }
  for (TyreSpec& tyre : robot.tyre) tyre.hub_offset_m = 0.12 * tyre.radius_m;
}

void wheel_scale_mismatch(RobotSpec& robot, double level, Random& random) {
  const double half = 0.5 * random.sign() * sized(0.008, 0.05, level);
  robot.tyre[left_side].rolling_factor *= 1.0 + half;
  robot.tyre[right_side].rolling_factor *= 1.0 - half;
}

void distance_scale(RobotSpec& robot, double level, Random& random) {
  const double factor = 1.0 + random.sign() * sized(0.018, 0.08, level);
  for (TyreSpec& tyre : robot.tyre) tyre.rolling_factor *= factor;
}

void acceleration_slip(RobotSpec& robot, double level, Random&) {
  const double shortest_start_s = sized(0.2, 0.6, level);
  const double acceleration_m_s2 = robot.fastest_m_s / shortest_start_s;
  for (TyreSpec& tyre : robot.tyre) {
    tyre.peak_n = 0.5 * robot.body.mass_kg * acceleration_m_s2;
    tyre.shape = 1.6;
  }
}

void encoder_dropout(RobotSpec& robot, double level, Random&) {
  robot.encoder.outages_per_run = sized(3.0, 6.0, level);
  robot.encoder.shortest_outage_s = sized(0.15, 0.30, level);
  robot.encoder.longest_outage_s = sized(0.30, 0.90, level);
}

}  // namespace

std::vector<Effect> drive_effects() {
  return {
      {"coulomb_friction",
       Drive::soft,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks},
       true,
       coulomb_friction,
       "LuGre friction in the gearbox, breakaway force equal to the sliding force"},
      {"stiction",
       Drive::soft,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks},
       true,
       stiction,
       "LuGre friction in the gearbox, breakaway 17 times the sliding force, Stribeck speed 12 mm/s"},
      {"backlash",
       Drive::stiff,
       {ticks, ticks_and_poses},
       {ticks_and_poses, ticks},
       true,
       backlash,
       "rotor and wheel as two masses with a spring gap; encoder on the wheel, tachometer on the motor"},
      {"wheel_eccentricity",
       Drive::any,
       {ticks, ticks_and_poses},
       {ticks_and_poses},
       true,
       wheel_eccentricity,
       "small: off-centre output gear (ticks show it); large: wheel bored off centre (only poses show it)"},
      {"wheel_scale_mismatch",
       Drive::any,
       {ticks_and_poses},
       {ticks_and_ends, ticks_and_poses},
       false,
       wheel_scale_mismatch,
       "left and right tyres of different true radius"},
      {"distance_scale",
       Drive::any,
       {ticks_and_poses},
       {ticks_and_ends, ticks_and_poses},
       false,
       distance_scale,
       "both tyres of another true radius than the calibrated one"},
      {"acceleration_slip",
       Drive::stiff,
       {ticks_and_poses},
       {ticks_and_poses},
       true,
       acceleration_slip,
       "tyres on a slippery floor: Pacejka force peaks below what the motors ask for (spins and slides)"},
      {"encoder_dropout",
       Drive::any,
       {ticks_and_poses, ticks},
       {ticks, ticks_and_poses},
       false,
       encoder_dropout,
       "edges pass uncounted during outages, each wheel on its own"},
  };
}

}  // namespace plants::second
