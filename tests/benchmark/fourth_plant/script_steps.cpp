// Programmes that are made of segments.
#include <algorithm>
#include <array>
#include <numbers>

#include "tests/benchmark/fourth_plant/script.hpp"

namespace plants::fourth {

namespace {

constexpr double slowest_m_s = 0.05;

double some_speed(const Script& script, Random& random) {
  return random.uniform(slowest_m_s, script.limits().fastest_m_s);
}

}  // namespace

// A pseudo-random sequence with a handful of levels, each channel with a clock of its own.
void write_random_steps(Script& script, Random& random) {
  constexpr std::array levels{-1.0, -0.6, -0.3, -0.15, 0.0, 0.15, 0.3, 0.6, 1.0};
  const auto any_level = [&] {
    return levels[static_cast<std::size_t>(random.integer(0, static_cast<int>(levels.size()) - 1))];
  };
  const DriveLimits& limits = script.limits();
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  while (!script.done()) {
    if (random.chance(0.6)) forward_m_s = limits.fastest_m_s * any_level();
    if (random.chance(0.5)) turn_rad_s = limits.fastest_turn_rad_s * any_level();
    script.hold(forward_m_s, turn_rad_s, random.uniform(0.25, 1.2));
  }
}

// A slow triangle, then stairs down to the other side, then the same the other way round.
void write_stairs(Script& script, Random& random, bool straight) {
  double side = random.sign();
  while (!script.done()) {
    const double turn_rad_s = straight ? 0.0 : random.signed_uniform(0.2, 0.8);
    const double peak_m_s = side * random.uniform(0.4, 1.0) * script.limits().fastest_m_s;
    script.ramp(peak_m_s, turn_rad_s, random.uniform(2.0, 4.0));
    script.ramp(0.0, 0.0, random.uniform(2.0, 4.0));
    const int steps = random.integer(3, 5);
    for (int step = -steps; step <= steps; ++step)
      script.hold(peak_m_s * step / steps, turn_rad_s * step / steps, random.uniform(0.5, 1.0));
    script.hold(0.0, 0.0, random.uniform(0.3, 0.8));
    side = -side;
  }
}

void write_stop_and_go(Script& script, Random& random) {
  while (!script.done()) {
    const double speed_m_s = some_speed(script, random);
    script.hold(speed_m_s, 0.0, random.uniform(0.8, 2.5));
    if (random.chance(0.6)) script.hold(0.0, 0.0, random.uniform(0.4, 1.2));
    script.hold(-some_speed(script, random), 0.0, random.uniform(0.8, 2.0));
    if (random.chance(0.6)) script.hold(0.0, 0.0, random.uniform(0.4, 1.2));
    const double turn_rad_s = random.signed_uniform(0.3, 1.0) * script.limits().fastest_turn_rad_s;
    if (random.chance(0.5)) script.hold(0.0, turn_rad_s, random.uniform(0.5, 1.5));
    // Creeping up to something.
    if (random.chance(0.4)) script.ramp(random.sign() * slowest_m_s, 0.0, random.uniform(1.0, 2.0));
  }
}

void write_spins(Script& script, Random& random) {
  while (!script.done()) {
    const double turn_rad_s = random.signed_uniform(0.15, 1.0) * script.limits().fastest_turn_rad_s;
    script.hold(0.0, turn_rad_s, random.uniform(1.5, 3.5));
    if (random.chance(0.5)) script.hold(0.0, 0.0, random.uniform(0.3, 0.8));
    const double speed_m_s = random.sign() * some_speed(script, random);
    script.hold(speed_m_s, 0.0, random.uniform(0.8, 1.8));
    script.hold(0.6 * speed_m_s, random.signed_uniform(0.1, 0.7) * script.limits().fastest_turn_rad_s,
                random.uniform(1.0, 2.5));
  }
}

// Figures of eight, and squares whose corners are rounded; never backwards with any wheel.
void write_laps(Script& script, Random& random) {
  while (!script.done()) {
    const double speed_m_s = random.uniform(0.4, 0.95) * script.limits().fastest_m_s;
    const double radius_m = random.uniform(0.3, 0.5);
    const double side = random.sign();
    const double turn_rad_s = std::min(speed_m_s / radius_m, script.limits().fastest_turn_rad_s);
    const double quarter_s = 0.5 * std::numbers::pi / turn_rad_s;
    script.ramp(speed_m_s, 0.0, 0.6);
    if (random.chance(0.5)) {
      for (const double bend : {side, -side}) script.hold(speed_m_s, bend * turn_rad_s, 4.0 * quarter_s);
      continue;
    }
    const double edge_s = random.uniform(0.4, 0.9) / speed_m_s;
    for (int corner = 0; corner < 4; ++corner) {
      script.hold(speed_m_s, 0.0, edge_s);
      script.hold(speed_m_s, side * turn_rad_s, quarter_s);
    }
  }
}

}  // namespace plants::fourth
