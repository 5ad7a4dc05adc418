// Effects of the wheels on the floor, and of the floor.
#include <cmath>
#include <numbers>

#include "tests/benchmark/fourth_plant/body_blocks.hpp"
#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/fourth_plant/floor_load.hpp"
#include "tests/benchmark/fourth_plant/wheel_blocks.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fourth {

namespace {

double any_direction_rad(Random& random) {
  return random.uniform(-std::numbers::pi, std::numbers::pi);
}

// Beside the place where the runs start, so that every run crosses its edge.
Disc any_disc(Random& random) {
  const double bearing_rad = any_direction_rad(random);
  constexpr double away_m = 0.4;
  return {away_m * std::cos(bearing_rad), away_m * std::sin(bearing_rad), random.uniform(0.45, 0.6)};
}

std::string hide_mismatch(const Setting& setting) {
  const double scale = 1.0 + setting.random.sign() * drawn(setting, {0.015, 0.02}, {0.04, 0.06});
  setting.diagram().floor[right_side].emplace_back(Scale{scale});
  return "diameter of the right wheel times " + fixed(scale, 4);
}

std::string hide_distance_scale(const Setting& setting) {
  const double scale = 1.0 + setting.random.sign() * drawn(setting, {0.022, 0.03}, {0.07, 0.1});
  add_to_both(setting.diagram().floor, Scale{scale});
  return "diameter of both wheels times " + fixed(scale, 4);
}

std::string hide_acceleration_slip(const Setting& setting) {
  const double slip_s = drawn(setting, {0.035, 0.045}, {0.12, 0.16});
  const double grip_m_s2 = setting.random.uniform(0.5, 0.7);
  const double relaxation_m = setting.random.uniform(0.006, 0.012);
  add_to_both(setting.diagram().floor, SlippingTyre{grip_m_s2, slip_s, relaxation_m});
  return "tyre slips by " + fixed(slip_s, 3) + " s times what the acceleration exceeds " +
         fixed(grip_m_s2, 2) + " m/s2";
}

// Small: gravity loads the motors, and the encoders see it; large: the tyres creep.
std::string hide_slope(const Setting& setting) {
  const double speed_m_s = drawn(setting, {0.011, 0.015}, {0.03, 0.04});
  const double downhill_rad = any_direction_rad(setting.random);
  const std::string text = fixed(1000.0 * speed_m_s, 0) + " mm/s downhill, ";
  if (setting.large) {
    setting.diagram().body.emplace_back(Creep{speed_m_s, downhill_rad});
    return text + "of tyres that creep";
  }
  add_to_both(setting.diagram().load, GravityLoad{speed_m_s, downhill_rad});
  return text + "of motors without a speed loop";
}

// Small: a rug on which tyres lose way; large: a carpet that brakes the motors.
std::string hide_patch(const Setting& setting) {
  const Disc disc = any_disc(setting.random);
  const double share = 1.0 - drawn(setting, {0.07, 0.09}, {0.22, 0.28});
  if (setting.large) {
    add_to_both(setting.diagram().drive, Carpet{disc, share});
  } else {
    setting.diagram().body.emplace_back(Rug{disc, share});
  }
  return "speed times " + fixed(share, 3) + " within " + fixed(disc.radius_m, 2) + " m of a point, " +
         (setting.large ? "motors braked" : "tyres slip");
}

}  // namespace

std::vector<Effect> floor_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"wheel_scale_mismatch",
       {.sensing = ticks_and_ends, .programme = waypoints, .confusable = "yaw_bias"},
       {.sensing = ticks_and_poses, .programme = stop_and_go},
       hide_mismatch},
      {"distance_scale",
       {.sensing = ticks_and_ends, .programme = random_steps},
       {.sensing = ticks_and_poses, .programme = laps, .pose_every_s = 1.0},
       hide_distance_scale},
      {"acceleration_slip",
       {.sensing = ticks_and_poses, .programme = stop_and_go},
       {.sensing = ticks_and_poses, .programme = random_steps},
       hide_acceleration_slip},
      {"floor_slope",
       {.sensing = ticks_and_poses, .programme = laps, .loop = Loop::open},
       {.sensing = ticks_and_poses, .programme = waypoints},
       hide_slope},
      {"surface_patch",
       {.sensing = ticks_and_poses, .programme = waypoints},
       {.sensing = ticks_and_poses, .programme = laps, .loop = Loop::open},
       hide_patch},
  };
}

}  // namespace plants::fourth
