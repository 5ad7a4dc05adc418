// Effects of the body, its undercarriage, the floor and the outside reference.
#include <cmath>
#include <numbers>

#include "tests/benchmark/plants/text.hpp"
#include "tests/benchmark/third_plant/effects.hpp"

namespace plants::third {

namespace {

using enum Sensing;
using enum Style;

double any_direction_rad(Random& random) {
  return random.uniform(-std::numbers::pi, std::numbers::pi);
}

std::string effective_track(Setting& setting) {
  UndercarriageSpec& under = setting.robot.undercarriage;
  under.track_m *= setting.sized(1.025, 1.032, 1.09, 1.12);
  return "wide tyres bear outside: turning base " + fixed(under.track_m, 3) + " m, header says " +
         fixed(setting.robot.wheel_base_m, 3);
}

std::string turn_speed_loss(Setting& setting) {
  const double loss_m = setting.sized(0.008, 0.01, 0.026, 0.03);
  setting.robot.undercarriage.turn_loss_m = loss_m;
  return "tyre creep from side drag: " + millimetres(loss_m) + "/s of forward speed lost per rad/s";
}

std::string turn_scrub(Setting& setting) {
  UndercarriageSpec& under = setting.robot.undercarriage;
  under.scrub = setting.sized(0.07, 0.085, 0.22, 0.26);
  under.scrub_power = setting.random.chance(0.5) ? 1 : 2;
  setting.habits.pivot_share = 0.3;
  return "contact patches drag sideways: turn rate divided by 1+" + fixed(under.scrub, 2) + " (w/" +
         fixed(under.fastest_turn_rad_s, 1) + " rad/s)^" + std::to_string(under.scrub_power);
}

std::string yaw_bias(Setting& setting) {
  const double size_rad_s = setting.sized(0.014, 0.018, 0.045, 0.06);
  setting.robot.undercarriage.side_brush_rad_s = size_rad_s * setting.random.sign();
  return "side brush pushes: " + fixed(setting.robot.undercarriage.side_brush_rad_s, 3) +
         " rad/s whenever the wheels turn";
}

std::string floor_slope(Setting& setting) {
  const double lost_m_s = setting.sized(0.0055, 0.007, 0.02, 0.025);
  setting.robot.floor.slope_n = setting.force_n(lost_m_s);
  setting.robot.floor.uphill_rad = any_direction_rad(setting.random);
  return "floor rises towards " + fixed(setting.robot.floor.uphill_rad, 2) +
         " rad: " + millimetres(lost_m_s) + "/s slower uphill, faster downhill, gear holds at rest";
}

std::string round_rug(RugSpec& rug, Random& random) {
  rug.shape = RugShape::round;
  rug.half_length_m = random.uniform(0.5, 0.65);
  rug.roll = random.uniform(0.84, 0.88);
  return "round rug, " + fixed(rug.half_length_m, 2) + " m radius: a wheel on it sinks in, " +
         per_cent(1.0 - rug.roll) + " less roll";
}

std::string surface_patch(Setting& setting) {
  Random& random = setting.random;
  RugSpec& rug = setting.robot.floor.rug;
  const double bearing_rad = any_direction_rad(random);
  const double away_m = random.uniform(0.3, 0.5);
  rug.x_m = setting.habits.room_x_m + away_m * std::cos(bearing_rad);
  rug.y_m = setting.habits.room_y_m + away_m * std::sin(bearing_rad);
  if (setting.large) return round_rug(rug, random);
  rug.shape = RugShape::square;
  rug.turned_rad = random.uniform(0.0, std::numbers::pi);
  rug.half_length_m = random.uniform(0.6, 0.75);
  rug.half_width_m = random.uniform(0.45, 0.55);
  const std::string what =
      "rug " + fixed(2.0 * rug.half_length_m, 2) + " x " + fixed(2.0 * rug.half_width_m, 2) + " m: ";
  if (random.chance(0.5) && !setting.robot.controller.closed_loop) {
    const double lost = random.uniform(0.085, 0.1);
    rug.drag_n_s_m = setting.force_n(lost);
    return what + "rolling drag takes " + per_cent(lost) + " of the wheel speed on it";
  }
  rug.roll = random.uniform(0.93, 0.945);
  return what + "a wheel on it rolls " + per_cent(1.0 - rug.roll) + " less";
}

std::string caster_kick(Setting& setting) {
  constexpr double swing_integral = 1.3;  // of across^2 over the travel in trails
  UndercarriageSpec& under = setting.robot.undercarriage;
  const double kick_rad = setting.sized(0.045, 0.055, 0.13, 0.16);
  under.caster_trail_m = setting.random.uniform(0.011, 0.015);
  under.caster_rad_m = kick_rad / (swing_integral * under.caster_trail_m) * setting.random.sign();
  return "caster swings round within some " + fixed(500.0 * under.caster_trail_m, 0) +
         " cm after the travel flips, over the same side both ways: " + fixed(kick_rad, 2) +
         " rad in all, sign with the new direction";
}

std::string lever_arm(Setting& setting) {
  const double bearing_rad = any_direction_rad(setting.random);
  const double length_m = setting.sized(0.010, 0.013, 0.05, 0.08);
  setting.robot.marker_x_m = length_m * std::cos(bearing_rad);
  setting.robot.marker_y_m = length_m * std::sin(bearing_rad);
  return "marker at x " + millimetres(setting.robot.marker_x_m) + ", y " +
         millimetres(setting.robot.marker_y_m) + " from mid axle";
}

}  // namespace

std::vector<Effect> floor_effects() {
  return {
      {"effective_track", effective_track, {ticks_and_poses, joystick}, {ticks_and_ends, go_and_turn}},
      {"turn_speed_loss", turn_speed_loss, {ticks_and_poses, joystick}, {poses, random_steps}, 10.0},
      {"turn_scrub", turn_scrub, {ticks_and_poses, go_and_turn}, {poses, random_steps}, 10.0},
      {"yaw_bias", yaw_bias, {ticks_and_poses, random_steps}, {ticks_and_ends, slow_fast_mixture}},
      {"floor_slope",
       floor_slope,
       {poses, random_steps, Loop::open},
       {ticks_and_poses, go_and_turn, Loop::open}},
      {"surface_patch", surface_patch, {ticks_and_poses, joystick}, {poses, random_steps}, 10.0},
      {"caster_kick", caster_kick, {ticks_and_poses, go_and_turn}, {poses, random_steps}, 20.0},
      {"lever_arm", lever_arm, {ticks_and_poses, go_and_turn}, {poses, joystick}, 10.0},
  };
}

}  // namespace plants::third
