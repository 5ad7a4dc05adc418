// Effects of the body: its track, its castor, and what turning costs.
#include "tests/benchmark/fourth_plant/body_blocks.hpp"
#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fourth {

namespace {

std::string hide_track(const Setting& setting) {
  const double wider = 1.0 + setting.random.sign() * drawn(setting, {0.03, 0.045}, {0.1, 0.14});
  setting.diagram().body.emplace_back(TurnRatio{1.0 / wider});
  return "true track is " + fixed(wider, 3) + " times the given one";
}

std::string hide_turn_speed_loss(const Setting& setting) {
  const double drag_m = drawn(setting, {0.01, 0.014}, {0.03, 0.045});
  setting.diagram().body.emplace_back(DragWhileTurning{drag_m});
  return "castor drag takes " + fixed(1000.0 * drag_m, 0) + " mm/s of forward speed for each rad/s";
}

std::string hide_scrub(const Setting& setting) {
  const double scrub_s = drawn(setting, {0.035, 0.05}, {0.13, 0.18});
  setting.diagram().body.emplace_back(Scrub{scrub_s});
  return "turn rate over 1 + " + fixed(scrub_s, 3) + " s times its size";
}

std::string hide_yaw_bias(const Setting& setting) {
  const double rate_rad_s = setting.random.sign() * drawn(setting, {0.014, 0.018}, {0.05, 0.07});
  setting.diagram().body.emplace_back(Pull{rate_rad_s});
  return "skewed axle pulls by " + fixed(rate_rad_s, 3) + " rad/s while rolling";
}

// Small: always to the side where the castor's stop is; large: to the side the travel asks for.
std::string hide_caster_kick(const Setting& setting) {
  const double angle_rad = setting.random.sign() * drawn(setting, {0.04, 0.055}, {0.12, 0.18});
  const double way_m = setting.random.uniform(0.03, 0.06);
  setting.diagram().body.emplace_back(CastorSwing{angle_rad, way_m, setting.large});
  return "castor kicks by " + fixed(angle_rad, 3) + " rad over " + fixed(1000.0 * way_m, 0) +
         " mm after a flip" + (setting.large ? ", side as the travel" : ", always to one side");
}

std::string hide_lever_arm(const Setting& setting) {
  setting.robot().marker_x_m = setting.random.sign() * drawn(setting, {0.02, 0.03}, {0.08, 0.11});
  if (setting.large) setting.robot().marker_y_m = setting.random.signed_uniform(0.02, 0.04);
  return "marker " + fixed(1000.0 * setting.robot().marker_x_m, 0) + " mm ahead and " +
         fixed(1000.0 * setting.robot().marker_y_m, 0) + " mm to the left of the middle of the axle";
}

}  // namespace

std::vector<Effect> body_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"effective_track",
       {.sensing = ticks_and_poses, .programme = spins, .pose_every_s = 1.0, .confusable = "turn_scrub"},
       {.sensing = poses, .programme = random_steps},
       hide_track},
      {"turn_speed_loss",
       {.sensing = ticks_and_poses, .programme = random_steps},
       {.sensing = poses, .programme = multi_sine},
       hide_turn_speed_loss},
      {"turn_scrub",
       {.sensing = ticks_and_poses, .programme = spins, .confusable = "effective_track"},
       {.sensing = ticks_and_poses, .programme = multi_sine, .pose_every_s = 0.1},
       hide_scrub},
      {"yaw_bias",
       {.sensing = poses, .programme = stop_and_go},
       {.sensing = ticks_and_poses, .programme = waypoints, .pose_every_s = 1.0},
       hide_yaw_bias},
      {"caster_kick",
       {.sensing = ticks_and_poses, .programme = stop_and_go},
       {.sensing = ticks_and_poses, .programme = random_steps},
       hide_caster_kick},
      {"lever_arm",
       {.sensing = ticks_and_poses, .programme = spins},
       {.sensing = poses, .programme = multi_sine},
       hide_lever_arm},
  };
}

}  // namespace plants::fourth
