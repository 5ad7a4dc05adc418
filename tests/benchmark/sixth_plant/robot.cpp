#include "tests/benchmark/sixth_plant/robot.hpp"

#include <array>

namespace plants::sixth {

namespace {

void draw_masses(Robot& robot, Random& random) {
  robot.mass_kg = random.uniform(0.7, 1.8);
  robot.yaw_inertia_kg_m2 =
      robot.mass_kg * robot.wheel_base_m * robot.wheel_base_m / 4 * random.uniform(0.8, 1.2);
  robot.wheel_kg = random.uniform(0.12, 0.2);
  // Behind such a gear the motor weighs more than what it moves.
  const double moved_kg = robot.mass_kg / 2 + robot.wheel_kg;
  robot.motor_kg = moved_kg * random.uniform(2, 4);
  const double yield_n_s_m = (robot.motor_kg + moved_kg) / robot.response_s;
  const double drag_share = random.uniform(0.1, 0.2);
  robot.drag_n_s_m = yield_n_s_m * drag_share;
  robot.motor_n_s_m = yield_n_s_m - robot.drag_n_s_m;
}

void draw_timing(Robot& robot, Random& random) {
  constexpr std::array periods_s{0.01, 0.015, 0.02, 0.025, 0.03, 0.04, 0.05};
  constexpr double jitter_chance = 0.35;
  const int last = static_cast<int>(periods_s.size()) - 1;
  robot.period_s = periods_s[static_cast<std::size_t>(random.integer(0, last))];
  robot.jitters = random.chance(jitter_chance);
  robot.latency_s = robot.period_s * random.uniform(0.1, 1.0) + 0.002;
}

NoiseSpec drawn_noise(double least, double most, double shortest_s, double longest_s, Random& random) {
  const double sigma = random.uniform(least, most);
  return {sigma, random.uniform(shortest_s, longest_s)};
}

NoiseSpecs drawn_noises(Random& random) {
  NoiseSpecs noise;
  noise.fast_m_s = drawn_noise(0.0006, 0.0013, 0.03, 0.12, random);
  noise.slow_m_s = drawn_noise(0.0002, 0.0005, 0.3, 1.5, random);
  noise.loop_m_s = random.uniform(0.001, 0.003);
  noise.turn_rad_s = drawn_noise(0.001, 0.004, 0.1, 0.5, random);
  noise.forward_m_s = drawn_noise(0.0002, 0.0006, 0.1, 0.5, random);
  noise.seen_m = random.uniform(0.0006, 0.0016);
  noise.seen_rad = random.uniform(0.002, 0.006);
  noise.seen_slow_m = noise.seen_m * 0.3;
  return noise;
}

}  // namespace

Robot random_robot(Random& random) {
  Robot robot;
  robot.wheel_base_m = random.uniform(0.11, 0.20);
  robot.top_m_s = random.uniform(0.25, 0.5);
  robot.gain = random.uniform(0.95, 1.05);
  robot.response_s = random.uniform(0.05, 0.15);
  robot.smoothing_s = random.uniform(0.005, 0.04);
  draw_masses(robot, random);
  robot.creep_n_s_m = random.uniform(180, 400);
  robot.wheel_radius_m = random.uniform(0.018, 0.035);
  robot.metres_per_tick = random.uniform(0.0001, 0.0004);
  draw_timing(robot, random);
  robot.noise = drawn_noises(random);
  robot.battery_v = random.chance(0.5) ? 7.2 : 11.1;
  robot.castor_arm_m = robot.wheel_base_m * random.uniform(0.4, 0.7);
  robot.castor_trail_m = random.uniform(0.008, 0.014);
  robot.gear_turns = random.uniform(0.31, 0.43);
  return robot;
}

}  // namespace plants::sixth
