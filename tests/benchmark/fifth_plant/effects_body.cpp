// What acts on the body, and where it is measured.
#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

std::string hide_turn_speed_loss(const Setting& setting) {
  const double loss_m = setting.drawn(0.012, 0.018, 0.05, 0.08);
  setting.robot().body.turn_drag_n_s = force_n(setting.robot(), loss_m);
  return "castors that are dragged across take " + fixed(loss_m, 4) + " m/s for each rad/s of turn";
}

std::string hide_turn_scrub(const Setting& setting) {
  const double share = setting.drawn(0.07, 0.1, 0.2, 0.3);
  const double fastest_rad_s = setting.experiment.style.turn_rad_s;
  setting.robot().body.scrub_n_m_s2 =
      moment_n_m(setting.robot(), share * fastest_rad_s) / (fastest_rad_s * fastest_rad_s);
  return "wide tyres scrub by the square of the turn rate: " + fixed(100.0 * share, 1) + " % at " +
         fixed(fastest_rad_s, 2) + " rad/s";
}

// Small: a trim of the steering; large: a brush under the robot that runs while it drives.
std::string hide_yaw_bias(const Setting& setting) {
  const double bias_rad_s = setting.random.sign() * setting.drawn(0.01, 0.015, 0.04, 0.07);
  if (!setting.large) {
    setting.robot().firmware.trim_rad_s = bias_rad_s;
    return "the steering is trimmed by " + fixed(bias_rad_s, 4) + " rad/s";
  }
  setting.robot().body.brush_n_m = moment_n_m(setting.robot(), bias_rad_s);
  return "a brush turns the robot by " + fixed(bias_rad_s, 4) + " rad/s while driving";
}

std::string hide_caster_kick(const Setting& setting) {
  Robot& robot = setting.robot();
  const double kick_rad_s = setting.drawn(0.025, 0.04, 0.2, 0.35);
  robot.body.swivel_trail_m = setting.random.uniform(0.03, 0.05);
  const double moment = moment_n_m(robot, kick_rad_s);
  robot.body.swivel_n_m = moment * robot.body.swivel_trail_m / robot.body.swivel_x_m;
  return "the swivel of the front castor holds with " + fixed(robot.body.swivel_n_m, 2) +
         " Nm at a trail of " + fixed(1000.0 * robot.body.swivel_trail_m, 0) + " mm";
}

std::string hide_lever_arm(const Setting& setting) {
  TrackerSpec& tracker = setting.robot().tracker;
  tracker.marker_x_m = setting.random.sign() * setting.drawn(0.012, 0.02, 0.07, 0.13);
  tracker.marker_y_m = setting.drawn(-0.01, 0.01, -0.05, 0.05);
  return "the marker is " + fixed(1000.0 * tracker.marker_x_m, 0) + " mm ahead of the axle and " +
         fixed(1000.0 * tracker.marker_y_m, 0) + " mm to the left";
}

}  // namespace

std::vector<Effect> body_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"turn_speed_loss",
       {.programme = turning, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = teleoperation, .drive = Drive::soft},
       hide_turn_speed_loss},
      {"turn_scrub",
       {.programme = turning, .drive = Drive::soft, .confusable = "gain_curve effective_track"},
       {.sensing = ticks_and_poses,
        .programme = teleoperation,
        .drive = Drive::soft,
        .confusable = "effective_track"},
       hide_turn_scrub},
      {"yaw_bias",
       {.sensing = ticks_and_poses, .programme = corridor},
       {.sensing = poses, .programme = teleoperation, .drive = Drive::soft},
       hide_yaw_bias},
      {"caster_kick",
       {.sensing = ticks_and_poses, .programme = corridor, .drive = Drive::soft, .pose_every_s = 0.0},
       {.sensing = ticks_and_poses, .programme = corridor, .drive = Drive::soft},
       hide_caster_kick},
      {"lever_arm",
       {.sensing = ticks_and_poses, .programme = turning},
       {.sensing = poses, .programme = patrol},
       hide_lever_arm},
  };
}

}  // namespace plants::fifth
