// Effects of the body, its undercarriage, the floor and the outside reference.
#include <cmath>
#include <numbers>

#include "tests/benchmark/second_plant/effects.hpp"

namespace plants::second {

namespace {

using enum Sensing;

void effective_track(RobotSpec& robot, double level, Random& random) {
  robot.body.true_track_m *= 1.0 + random.sign() * sized(0.025, 0.12, level);
}

void turn_speed_loss(RobotSpec& robot, double level, Random&) {
  robot.undercarriage.felt_drag_n_s_rad = 2.0 * sized(0.014, 0.05, level) * robot.drive_stiffness_n_s_m();
}

void turn_scrub(RobotSpec& robot, double level, Random&) {
  constexpr double kHardTurn_rad_s = 1.5;
  UndercarriageSpec& under = robot.undercarriage;
  under.skid_rate_rad_s = 0.8;
  under.skid_moment_n_m = 1.0;
  const double shape = -skid_moment_n_m(under, kHardTurn_rad_s);
  const double share = sized(0.08, 0.35, level);
  under.skid_moment_n_m = share * kHardTurn_rad_s * robot.turn_stiffness_n_m_s() / shape;
}

void yaw_bias(RobotSpec& robot, double level, Random& random) {
  robot.undercarriage.side_brush_n_m =
      random.sign() * sized(0.008, 0.05, level) * robot.turn_stiffness_n_m_s();
}

void floor_slope(RobotSpec& robot, double level, Random& random) {
  const double pull_n = 2.0 * sized(0.009, 0.035, level) * robot.drive_stiffness_n_s_m();
  robot.floor.tilt_rad = std::asin(pull_n / (robot.body.mass_kg * kGravity_m_s2));
  robot.floor.downhill_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
}

void surface_patch(RobotSpec& robot, double level, Random& random) {
  FloorSpec& floor = robot.floor;
  floor.rug_radius_m = random.uniform(0.5, 0.7);
  floor.rug_x_m = random.uniform(-0.5, 0.5);
  floor.rug_y_m = random.uniform(-0.5, 0.5);
  floor.rug_drag_n_s_m = sized(0.10, 0.45, level) * robot.drive_stiffness_n_s_m();
  floor.rug_grip = 0.6;
}

void caster_kick(RobotSpec& robot, double level, Random& random) {
  UndercarriageSpec& under = robot.undercarriage;
  under.caster_moment_n_m = sized(0.15, 0.6, level) * robot.turn_stiffness_n_m_s();
  under.caster_trail_m = random.uniform(0.02, 0.035);
}

void lever_arm(RobotSpec& robot, double level, Random& random) {
  const double length_m = sized(0.012, 0.06, level);
  const double bearing_rad = random.uniform(-0.6, 0.6) + (random.chance(0.5) ? std::numbers::pi : 0.0);
  robot.reference_x_m = length_m * std::cos(bearing_rad);
  robot.reference_y_m = length_m * std::sin(bearing_rad);
}

}  // namespace

std::vector<Effect> floor_effects() {
  return {
      {"effective_track",
       Drive::any,
       {ticks_and_poses},
       {ticks_and_ends, ticks_and_poses},
       false,
       effective_track,
       "tyres touch the floor nearer or farther than the drawing says"},
      {"turn_speed_loss",
       Drive::soft,
       {ticks_and_poses, poses},
       {ticks_and_poses, poses},
       false,
       turn_speed_loss,
       "felt bristles bent sideways by the turn dig in and hold the body back"},
      {"turn_scrub",
       Drive::soft,
       {ticks_and_poses, poses},
       {poses, ticks_and_poses},
       false,
       turn_scrub,
       "skid ploughs when turning fast: yaw moment grows faster than the turn rate"},
      {"yaw_bias",
       Drive::soft,
       {ticks_and_poses, poses},
       {poses, ticks_and_poses},
       false,
       yaw_bias,
       "side brush pulls with a constant yaw moment while driving"},
      {"floor_slope",
       Drive::soft,
       {ticks_and_poses},
       {poses, ticks_and_poses},
       false,
       floor_slope,
       "gravity along the body axis on a tilted floor (the robot creeps downhill at rest too)"},
      {"surface_patch",
       Drive::soft,
       {ticks_and_poses, poses},
       {ticks_and_poses, poses},
       false,
       surface_patch,
       "round rug: pile resistance under each wheel and softer tyre grip"},
      {"caster_kick",
       Drive::soft,
       {ticks_and_poses, poses},
       {ticks_and_poses, poses},
       true,
       caster_kick,
       "caster swings round within some trail lengths after a reversal and ploughs while it stands across"},
      {"lever_arm",
       Drive::any,
       {ticks_and_poses, poses},
       {poses, ticks_and_poses},
       true,
       lever_arm,
       "the reference looks at a point off the middle of the axle"},
  };
}

}  // namespace plants::second
