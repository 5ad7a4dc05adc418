// Motor, gear and counters.
#include <numbers>

#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

std::string hide_coulomb_friction(const Setting& setting) {
  const double loss_m_s = setting.drawn(0.009, 0.013, 0.035, 0.055);
  set_both(setting.robot(), &GearSpec::dry_n_m, torque_n_m(setting.robot(), loss_m_s));
  return "dry friction in the gears takes " + fixed(loss_m_s, 4) + " m/s";
}

std::string hide_stiction(const Setting& setting) {
  Robot& robot = setting.robot();
  const double needed_m_s = setting.drawn(0.02, 0.03, 0.07, 0.1);
  constexpr double moving_share = 0.15;
  set_both(robot, &GearSpec::breakaway_n_m, torque_n_m(robot, needed_m_s));
  set_both(robot, &GearSpec::dry_n_m, torque_n_m(robot, moving_share * needed_m_s));
  set_both(robot, &GearSpec::stribeck_rad_s, 0.01 / robot.sides[left_side].wheel.radius_m);
  return "gears at rest break away at " + fixed(needed_m_s, 3) + " m/s, and moving lose 15 % of that";
}

std::string hide_voltage_sag(const Setting& setting) {
  Robot& robot = setting.robot();
  for (SideSpec& side : robot.sides) side.driver.follows_battery = true;
  robot.battery.fall_v_s = setting.drawn(0.01, 0.015, 0.03, 0.045);
  robot.battery.fall_between_v = setting.drawn(0.25, 0.4, 0.7, 1.0);
  robot.battery.resistance_ohm = setting.drawn(0.05, 0.1, 0.15, 0.3);
  return "the driver makes up for no battery: it falls by " + fixed(1000.0 * robot.battery.fall_v_s, 0) +
         " mV/s, and " + fixed(robot.battery.fall_between_v, 2) + " V between runs";
}

std::string hide_gain_drift(const Setting& setting) {
  Robot& robot = setting.robot();
  const double share = setting.drawn(0.05, 0.07, 0.14, 0.2);
  const double warming_s = setting.random.uniform(14.0, 26.0);
  const double torque_per_m_s = torque_n_m(robot, share);
  set_both(robot, &GearSpec::cold_viscous_n_m_s, torque_per_m_s * robot.sides[left_side].wheel.radius_m);
  set_both(robot, &GearSpec::warming_s, warming_s);
  return "cold grease takes " + fixed(100.0 * share, 1) + " % of the speed, and warms in " +
         fixed(warming_s, 0) + " s";
}

// A wheel that drags leans against the teeth that drive it, and does not run ahead.
void let_wheels_drag(Robot& robot) {
  constexpr double braking_m_s2 = 1.6;
  for (SideSpec& side : robot.sides)
    side.wheel.drag_n_m = 0.5 * robot.mass_kg * braking_m_s2 * side.wheel.radius_m;
}

std::string hide_backlash(const Setting& setting) {
  const double lost_m = setting.drawn(0.004, 0.006, 0.011, 0.016);
  set_both(setting.robot(), &GearSpec::gap_rad, lost_m / setting.robot().sides[left_side].wheel.radius_m);
  return "gears have play of " + fixed(1000.0 * lost_m, 1) + " mm of way, before the encoder";
}

// Small: the wheels sit off their axles; large: the last wheels of the gears do.
std::string hide_eccentricity(const Setting& setting) {
  const double share = setting.drawn(0.02, 0.03, 0.05, 0.08);
  for (SideSpec& side : setting.robot().sides) {
    const double phase_rad = setting.random.uniform(0.0, 2.0 * std::numbers::pi);
    (setting.large ? side.gear.runout : side.wheel.eccentricity) = share;
    (setting.large ? side.gear.runout_phase_rad : side.wheel.eccentricity_phase_rad) = phase_rad;
  }
  return std::string(setting.large ? "the last wheels of the gears run" : "the wheels sit") +
         " off their axles by " + fixed(100.0 * share, 1) + " %";
}

std::string hide_dropout(const Setting& setting) {
  EncoderSpec& encoder = setting.robot().encoder;
  encoder.dropout_every_s = setting.drawn(12.0, 16.0, 6.0, 9.0);
  encoder.dropout_s = setting.drawn(0.2, 0.3, 0.6, 1.0);
  return "a loose plug: one encoder is dead for " + fixed(encoder.dropout_s, 2) + " s every " +
         fixed(encoder.dropout_every_s, 0) + " s";
}

}  // namespace

std::vector<Effect> drive_effects() {
  using enum Sensing;
  using enum Programme;
  const Showing with_battery{.programme = teleoperation, .drive = Drive::soft, .confusable = "gain_drift"};
  return {
      {"coulomb_friction",
       {.programme = corridor, .drive = Drive::soft, .confusable = "dead_zone"},
       {.sensing = ticks_and_poses,
        .programme = teleoperation,
        .drive = Drive::soft,
        .confusable = "dead_zone"},
       hide_coulomb_friction},
      {"stiction",
       {.programme = slow, .drive = Drive::soft, .confusable = "dead_zone coulomb_friction"},
       {.programme = docking, .drive = Drive::soft, .confusable = "dead_zone coulomb_friction"},
       hide_stiction},
      {"voltage_sag", with_battery, with_battery, hide_voltage_sag},
      {"gain_drift",
       {.programme = teleoperation, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       hide_gain_drift},
      {"backlash",
       {.programme = corridor, .drive = Drive::stiff, .prepare = let_wheels_drag},
       {.sensing = ticks_and_poses,
        .programme = teleoperation,
        .drive = Drive::stiff,
        .prepare = let_wheels_drag},
       hide_backlash},
      {"wheel_eccentricity",
       {.sensing = ticks_and_poses, .programme = laps, .pose_every_s = 0.0},
       {.programme = corridor, .drive = Drive::stiff},
       hide_eccentricity},
      {"encoder_dropout",
       {.sensing = ticks_and_poses, .programme = teleoperation},
       {.programme = laps},
       hide_dropout},
  };
}

}  // namespace plants::fifth
