// Without a name in the contract: floor, cables and loads.
#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

// A grid of short bumps all over the room: no region that differs from another one.
std::string hide_joints(const Setting& setting) {
  Robot& robot = setting.robot();
  const double loss_m_s = setting.drawn(0.12, 0.18, 0.35, 0.5);
  robot.floor.joint_every_m = setting.random.uniform(0.3, 0.5);
  robot.floor.joint_n = 0.5 * force_n(robot, loss_m_s);
  return "joints of tiles every " + fixed(robot.floor.joint_every_m, 2) + " m hold a wheel with " +
         fixed(robot.floor.joint_n, 0) + " N";
}

// Pulls towards one place, the more the further: no slope.
std::string hide_tether(const Setting& setting) {
  Robot& robot = setting.robot();
  const double loss_m_s = setting.drawn(0.03, 0.045, 0.09, 0.13);
  robot.body.tether_n_m = force_n(robot, loss_m_s);
  robot.body.tether_length_m = 0.4;
  return "a charging cable pulls with " + fixed(robot.body.tether_n_m, 1) + " N for each metre beyond 0.4 m";
}

std::string hide_sliding_load(const Setting& setting) {
  Robot& robot = setting.robot();
  robot.body.load_kg = setting.drawn(0.22, 0.3, 0.45, 0.55) * robot.mass_kg;
  robot.body.load_play_m = setting.drawn(0.03, 0.05, 0.07, 0.1);
  robot.mass_kg -= robot.body.load_kg;
  return "a box of " + fixed(robot.body.load_kg, 1) + " kg slides in its tray by " +
         fixed(1000.0 * robot.body.load_play_m, 0) + " mm to either side";
}

// By itself: nothing in the commands is related to it.
std::string hide_turning_mast(const Setting& setting) {
  Robot& robot = setting.robot();
  constexpr double turning_rad_s2 = 12.0;
  robot.body.turret_kg_m2 = moment_n_m(robot, setting.drawn(0.16, 0.22, 0.4, 0.6)) / turning_rad_s2;
  robot.body.turret_every_s = setting.random.uniform(2.5, 4.0);
  return "a mast of " + fixed(robot.body.turret_kg_m2, 2) + " kg m^2 looks to the other side every " +
         fixed(robot.body.turret_every_s, 1) + " s";
}

}  // namespace

std::vector<Effect> outside_place_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"tile_joints",
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft},
       hide_joints},
      {"charging_cable",
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = teleoperation, .drive = Drive::soft},
       hide_tether},
      {"sliding_load",
       {.programme = errands, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = errands, .drive = Drive::soft},
       hide_sliding_load},
      {"turning_mast",
       {.programme = laps, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       hide_turning_mast},
  };
}

}  // namespace plants::fifth
