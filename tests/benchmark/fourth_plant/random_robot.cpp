#include "tests/benchmark/fourth_plant/random_robot.hpp"

#include <array>

namespace plants::fourth {

namespace {

Loop any_loop(Random& random) {
  constexpr std::array loops{Loop::open, Loop::open, Loop::proportional, Loop::integral};
  return loops[static_cast<std::size_t>(random.integer(0, static_cast<int>(loops.size()) - 1))];
}

DriveSpec random_drive(Loop loop, Random& random) {
  DriveSpec drive;
  drive.amplifier_lag_s = random.uniform(0.006, 0.02);
  drive.mechanical_lag_s = random.uniform(0.05, 0.12);
  drive.filtered = random.chance(0.5);
  drive.filter_rad_s = random.uniform(18.0, 40.0);
  drive.filter_damping = random.uniform(0.75, 1.0);
  if (loop == Loop::open) {
    drive.gain = random.uniform(0.95, 1.05);
    return drive;
  }
  drive.in_loop = true;
  drive.proportional = random.uniform(0.6, 1.4);
  if (loop == Loop::integral) drive.integral_per_s = random.uniform(3.0, 9.0);
  return drive;
}

double random_period_s(Random& random) {
  constexpr std::array periods_s{0.010, 0.015, 0.018, 0.020, 0.025};
  return periods_s[static_cast<std::size_t>(random.integer(0, static_cast<int>(periods_s.size()) - 1))];
}

}  // namespace

Robot random_robot(Loop loop, Random& random) {
  Robot robot;
  robot.wheel_base_m = random.uniform(0.15, 0.35);
  robot.top_m_s = random.uniform(0.28, 0.5);
  robot.metres_per_turn = random.uniform(0.14, 0.25);
  robot.metres_per_tick = random.log_uniform(0.0001, 0.001);
  robot.dead_time_s = random.uniform(0.005, 0.06);
  const DriveSpec drive = random_drive(loop == Loop::any ? any_loop(random) : loop, random);
  robot.drives = {drive, drive};
  robot.drives[right_side].mechanical_lag_s *= random.uniform(0.95, 1.05);
  robot.wheel_noise_m_s = random.uniform(0.0004, 0.0015);
  robot.wheel_noise_memory_s = random.uniform(0.05, 0.2);
  robot.battery.noise_v = random.uniform(0.005, 0.02);
  robot.reference_latency_s = random.chance(0.4) ? random.uniform(0.005, 0.04) : 0.0;
  robot.period_s = random_period_s(random);
  robot.jitter_s = random.chance(0.6) ? random.uniform(0.0002, 0.0006) : 0.0;
  return robot;
}

}  // namespace plants::fourth
