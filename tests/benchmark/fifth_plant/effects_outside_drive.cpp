// Without a name in the contract: drivers, gears and wheels.
#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

// Depends on what was driven before, and returns when it has cooled: no drift with time, no limit of speed.
std::string hide_foldback(const Setting& setting) {
  Robot& robot = setting.robot();
  const double share = setting.drawn(0.86, 0.9, 0.6, 0.7);
  const double hot_v = volts(robot, setting.random.uniform(0.35, 0.45) * robot.top_m_s);
  for (SideSpec& side : robot.sides) {
    side.driver.foldback_share = share;
    side.driver.foldback_cooling_s = 6.0;
    side.driver.foldback_heat_v2_s = hot_v * hot_v * side.driver.foldback_cooling_s;
  }
  return "a hot driver gives " + fixed(share, 2) + " of the voltage until it has cooled";
}

// A notch at one speed, where a gain curve bends over all of them.
std::string hide_resonance(const Setting& setting) {
  Robot& robot = setting.robot();
  const double loss_m_s = setting.drawn(0.04, 0.06, 0.1, 0.15);
  const double at_m_s = setting.random.uniform(0.35, 0.55) * robot.top_m_s;
  const double radius_m = robot.sides[left_side].wheel.radius_m;
  set_both(robot, &GearSpec::resonance_n_m, torque_n_m(robot, loss_m_s));
  set_both(robot, &GearSpec::resonance_rad_s, at_m_s / radius_m);
  set_both(robot, &GearSpec::resonance_width_rad_s, 0.035 / radius_m);
  return "gears that ring at " + fixed(at_m_s, 3) + " m/s take " + fixed(loss_m_s, 3) + " m/s there";
}

// Each start from rest is late by a time and then a lurch, however large the command.
std::string hide_parking_brake(const Setting& setting) {
  Robot& robot = setting.robot();
  const double release_s = setting.drawn(0.14, 0.2, 0.35, 0.5);
  set_both(robot, &DriverSpec::brake_release_s, release_s);
  return "the parking brake takes " + fixed(release_s, 2) + " s to let go, and the loop winds up meanwhile";
}

// One wheel, always by a whole spline, and only where the torque has its peaks.
std::string hide_loose_hub(const Setting& setting) {
  Robot& robot = setting.robot();
  WheelSpec& wheel = robot.sides[left_side].wheel;
  const double peak_m_s2 = setting.random.uniform(1.0, 1.3);
  wheel.hub_limit_n_m = 0.5 * robot.mass_kg * peak_m_s2 * wheel.radius_m;
  wheel.hub_jump_rad = setting.drawn(0.16, 0.22, 0.4, 0.6);
  return "the left hub jumps by " + fixed(wheel.hub_jump_rad, 2) + " rad beyond " +
         fixed(wheel.hub_limit_n_m, 2) + " Nm";
}

// The scale of one wheel drifts off within each run; motors and counters know nothing of it.
std::string hide_leak(const Setting& setting) {
  WheelSpec& wheel = setting.robot().sides[right_side].wheel;
  wheel.leak = setting.drawn(0.045, 0.06, 0.1, 0.16);
  wheel.leak_s = 45.0;
  return "the right tyre loses " + fixed(100.0 * wheel.leak, 1) + " % of its radius in 45 s";
}

// Twice a turn and short, on wheels that are centred; they roll as far in a turn as they should, and are
// climbed out of under the robot's weight.
std::string hide_flat_spots(const Setting& setting) {
  constexpr double mean = 0.141;  // of the flats over a turn
  constexpr double gravity_m_s2 = 9.81;
  constexpr double borne = 0.35;  // of the weight, by each wheel
  const double depth = setting.drawn(0.03, 0.045, 0.07, 0.1);
  for (SideSpec& side : setting.robot().sides) {
    side.wheel.flat_depth = depth;
    side.wheel.borne_n = borne * setting.robot().mass_kg * gravity_m_s2;
    side.wheel.radius_m *= 1.0 + mean * depth;
  }
  return "tyres with two flats each, of " + fixed(100.0 * depth, 1) + " % of the radius, from long standing";
}

}  // namespace

std::vector<Effect> outside_drive_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"thermal_foldback",
       {.programme = patrol, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = teleoperation, .drive = Drive::soft},
       hide_foldback},
      {"gear_resonance",
       {.programme = teleoperation, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = teleoperation, .drive = Drive::soft},
       hide_resonance},
      {"parking_brake",
       {.programme = errands, .drive = Drive::stiff},
       {.sensing = ticks_and_poses, .programme = docking, .drive = Drive::stiff},
       hide_parking_brake},
      {"loose_hub",
       {.sensing = ticks_and_poses, .programme = errands, .pose_every_s = 0.0},
       {.sensing = ticks_and_poses, .programme = errands},
       hide_loose_hub},
      {"leaking_tyre",
       {.sensing = ticks_and_poses, .programme = laps},
       {.sensing = ticks_and_poses, .programme = teleoperation},
       hide_leak},
      {"flat_spots",
       {.programme = corridor, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft},
       hide_flat_spots},
  };
}

}  // namespace plants::fifth
