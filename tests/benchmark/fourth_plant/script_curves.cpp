// Programmes that change all the time.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/benchmark/fourth_plant/script.hpp"
#include "tests/benchmark/plants/pose.hpp"

namespace plants::fourth {

namespace {

// A sum of sines with random phases whose sum hardly ever exceeds one.
class SumOfSines {
 public:
  explicit SumOfSines(Random& random) {
    double rate_hz = random.uniform(0.05, 0.08);
    for (Sine& sine : sines_) {
      sine = {2.0 * std::numbers::pi * rate_hz, random.uniform(0.0, 2.0 * std::numbers::pi)};
      rate_hz *= random.uniform(1.5, 2.4);
    }
  }

  [[nodiscard]] double at(double time_s) const {
    double sum = 0.0;
    for (const Sine& sine : sines_) sum += std::sin(sine.rate_rad_s * time_s + sine.start_rad);
    constexpr double default_peak = 2.6;
    return std::clamp(sum / default_peak, -1.0, 1.0);
  }

 private:
  struct Sine {
    double rate_rad_s = 0.0;
    double start_rad = 0.0;
  };
  std::array<Sine, 5> sines_;
};

struct Target {
  double x_m = 0.0;
  double y_m = 0.0;
  double speed_m_s = 0.0;
};

Target any_target(const Script& script, Random& random) {
  constexpr double room_m = 1.0;
  return {random.uniform(-room_m, room_m), random.uniform(-room_m, room_m),
          random.uniform(0.3, 0.95) * script.limits().fastest_m_s};
}

}  // namespace

void write_multi_sine(Script& script, Random& random) {
  const SumOfSines forward(random);
  const SumOfSines turn(random);
  constexpr double turn_share = 0.7;
  while (!script.done()) {
    script.add(script.limits().fastest_m_s * forward.at(script.time_s()),
               turn_share * script.limits().fastest_turn_rad_s * turn.at(script.time_s()));
  }
}

// Forward sweeps and turning sweeps in turn.
void write_chirp(Script& script, Random& random) {
  while (!script.done()) {
    const double start_s = script.time_s();
    const double sweep_s = random.uniform(9.0, 14.0);
    const double slow_hz = random.uniform(0.06, 0.12);
    const double fast_hz = random.uniform(0.9, 1.6);
    const double size = random.uniform(0.5, 1.0);
    const bool turning = random.chance(0.4);
    const double rate = std::log(fast_hz / slow_hz) / sweep_s;
    for (double since_s = 0.0; since_s < sweep_s && !script.done(); since_s = script.time_s() - start_s) {
      const double phase_rad = 2.0 * std::numbers::pi * slow_hz * (std::exp(rate * since_s) - 1.0) / rate;
      const double swing = size * std::sin(phase_rad);
      if (turning) {
        script.add(0.2 * script.limits().fastest_m_s, swing * script.limits().fastest_turn_rad_s);
      } else {
        script.add(swing * script.limits().fastest_m_s, 0.0);
      }
    }
    script.hold(0.0, 0.0, 0.5);
  }
}

// From point to point by the script's own dead reckoning of its commands, with the lag of a hand on a stick.
void write_waypoints(Script& script, Random& random) {
  constexpr double hand_lag_s = 0.3;
  constexpr double reached_m = 0.15;
  constexpr double turn_per_bearing = 1.6;
  Target target = any_target(script, random);
  Pose believed;
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  while (!script.done()) {
    const double away_x_m = target.x_m - believed.x_m;
    const double away_y_m = target.y_m - believed.y_m;
    if (std::hypot(away_x_m, away_y_m) < reached_m || random.chance(0.05 * script.period_s()))
      target = any_target(script, random);
    const double bearing_rad = wrapped_rad(std::atan2(away_y_m, away_x_m) - believed.heading_rad);
    const double share = script.period_s() / hand_lag_s;
    forward_m_s += share * (target.speed_m_s * std::max(0.4, std::cos(bearing_rad)) - forward_m_s);
    // The slower wheel may stand but not turn back.
    const double sharpest_rad_s =
        std::min(script.limits().fastest_turn_rad_s, 1.8 * forward_m_s / script.limits().wheel_base_m);
    const double wanted_rad_s = std::clamp(turn_per_bearing * bearing_rad, -sharpest_rad_s, sharpest_rad_s);
    turn_rad_s =
        std::clamp(turn_rad_s + share * (wanted_rad_s - turn_rad_s), -sharpest_rad_s, sharpest_rad_s);
    script.add(forward_m_s, turn_rad_s);
    believed.heading_rad += turn_rad_s * script.period_s();
    believed = point_of_body(believed, forward_m_s * script.period_s(), 0.0);
  }
}

}  // namespace plants::fourth
