// Where wheels meet the floor.
#include <numbers>

#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

std::string hide_scale_mismatch(const Setting& setting) {
  const double share = setting.random.sign() * setting.drawn(0.01, 0.014, 0.03, 0.05);
  setting.robot().sides[left_side].wheel.radius_m *= 1.0 - 0.5 * share;
  setting.robot().sides[right_side].wheel.radius_m *= 1.0 + 0.5 * share;
  return "the right wheel is " + fixed(100.0 * share, 2) + " % larger";
}

std::string hide_effective_track(const Setting& setting) {
  const double share = setting.random.sign() * setting.drawn(0.015, 0.025, 0.05, 0.09);
  Robot& robot = setting.robot();
  robot.wheel_base_m = robot.said_wheel_base_m * (1.0 + share);
  return "the wheels touch the floor " + fixed(100.0 * share, 2) + " % further apart than is said";
}

std::string hide_distance_scale(const Setting& setting) {
  const double share = setting.drawn(0.01, 0.016, 0.04, 0.06);
  for (SideSpec& side : setting.robot().sides) side.wheel.radius_m *= 1.0 - share;
  return "the tyres are worn by " + fixed(100.0 * share, 2) + " % of the radius";
}

std::string hide_slip(const Setting& setting) {
  Robot& robot = setting.robot();
  const double grip_m_s2 = setting.drawn(1.6, 1.9, 0.8, 1.0);
  robot.floor.grip_n = 0.5 * robot.mass_kg * grip_m_s2;
  return "dust: the tyres let go beyond " + fixed(grip_m_s2, 2) + " m/s^2";
}

std::string hide_slope(const Setting& setting) {
  Robot& robot = setting.robot();
  constexpr double gravity_m_s2 = 9.81;
  const double loss_m_s = setting.drawn(0.01, 0.014, 0.03, 0.05);
  robot.floor.slope_rad = force_n(robot, loss_m_s) / (robot.mass_kg * gravity_m_s2);
  robot.floor.uphill_rad = setting.random.uniform(-std::numbers::pi, std::numbers::pi);
  return "the floor rises by " + fixed(1000.0 * robot.floor.slope_rad, 1) + " mrad, which takes " +
         fixed(loss_m_s, 4) + " m/s uphill";
}

// Small: half of the room is carpet; large: a rug.
std::string hide_patch(const Setting& setting) {
  constexpr double far_m = 100.0;
  Robot& robot = setting.robot();
  const double share = setting.drawn(0.06, 0.09, 0.2, 0.3);
  const double radius_m = robot.sides[left_side].wheel.radius_m;
  Patch patch{-far_m, far_m, -far_m, far_m, torque_n_m(robot, share) / radius_m};
  const double edge_m = setting.random.uniform(-0.3, 0.3);
  if (setting.large) {
    patch.from_x_m = edge_m - 0.2;
    patch.to_x_m = edge_m + 1.6;
    patch.from_y_m = -1.2;
    patch.to_y_m = 1.2;
  } else {
    patch.from_x_m = edge_m;
  }
  robot.floor.patches.push_back(patch);
  return std::string(setting.large ? "a rug" : "carpet in half of the room") + " takes " +
         fixed(100.0 * share, 1) + " % of the speed";
}

}  // namespace

std::vector<Effect> floor_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"wheel_scale_mismatch",
       {.sensing = ticks_and_poses, .programme = corridor, .confusable = "yaw_bias"},
       {.sensing = ticks_and_ends, .programme = patrol, .confusable = "yaw_bias"},
       hide_scale_mismatch},
      {"effective_track",
       {.sensing = ticks_and_poses, .programme = turning, .confusable = "turn_scrub"},
       {.sensing = ticks_and_poses, .programme = patrol, .pose_every_s = 1.0, .confusable = "turn_scrub"},
       hide_effective_track},
      {"distance_scale",
       {.sensing = ticks_and_poses, .programme = patrol},
       {.sensing = ticks_and_poses, .programme = docking, .pose_every_s = 1.0},
       hide_distance_scale},
      {"acceleration_slip",
       {.sensing = ticks_and_poses, .programme = errands, .pose_every_s = 0.0},
       {.sensing = ticks_and_poses, .programme = errands},
       hide_slip},
      {"floor_slope",
       {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       hide_slope},
      {"surface_patch",
       {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       hide_patch},
  };
}

}  // namespace plants::fifth
