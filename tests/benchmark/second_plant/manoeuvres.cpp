#include "tests/benchmark/second_plant/manoeuvres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::second {

namespace {

constexpr double kFastestTurn_rad_s = 1.8;
constexpr double kSlowest_m_s = 0.04;

int row_count(const ProgrammeLimits& limits, double duration_s) {
  return std::max(1, static_cast<int>(std::lround(duration_s / limits.period_s)));
}

PerWheel<double> within_turn_limit(PerWheel<double> command_m_s, const ProgrammeLimits& limits) {
  const double middle_m_s = 0.5 * (command_m_s[left_side] + command_m_s[right_side]);
  const double widest_m_s = 0.5 * kFastestTurn_rad_s * limits.track_m;
  const double half_m_s =
      std::clamp(0.5 * (command_m_s[right_side] - command_m_s[left_side]), -widest_m_s, widest_m_s);
  return {middle_m_s - half_m_s, middle_m_s + half_m_s};
}

double random_speed_m_s(const ProgrammeLimits& limits, Random& random) {
  return random.sign() * random.uniform(kSlowest_m_s, limits.fastest_m_s);
}

PerWheel<double> independent_speeds(const ProgrammeLimits& limits, Random& random) {
  return within_turn_limit({random_speed_m_s(limits, random), random_speed_m_s(limits, random)}, limits);
}

PerWheel<double> pivot_speeds(const ProgrammeLimits& limits, Random& random) {
  const double top_m_s = std::min(limits.fastest_m_s, 0.5 * kFastestTurn_rad_s * limits.track_m);
  const double speed_m_s = random.sign() * random.uniform(0.03, top_m_s);
  return {-speed_m_s, speed_m_s};
}

PerWheel<double> arc_speeds(const ProgrammeLimits& limits, Random& random) {
  const double speed_m_s = random_speed_m_s(limits, random);
  const double share = random.uniform(0.3, 0.9);
  return within_turn_limit(random.chance(0.5) ? PerWheel<double>{speed_m_s, share * speed_m_s}
                                              : PerWheel<double>{share * speed_m_s, speed_m_s},
                           limits);
}

void append_sine(Programme& programme, const ProgrammeLimits& limits, Random& random) {
  const PerWheel<double> top_m_s = independent_speeds(limits, random);
  const double swing_s = random.uniform(2.5, 6.0);
  const int rows = row_count(limits, swing_s * (random.chance(0.5) ? 1.0 : 1.5));
  for (int row = 0; row < rows; ++row) {
    const double wave = std::sin(2.0 * std::numbers::pi * row * limits.period_s / swing_s);
    programme.push_back({top_m_s[left_side] * wave, top_m_s[right_side] * wave});
  }
}

void append_creeping(Programme& programme, const ProgrammeLimits& limits, Random& random) {
  append_hold(programme, limits, {0.0, 0.0}, random.uniform(0.5, 0.9));
  const double speed_m_s = random.sign() * random.uniform(0.01, 0.10);
  const PerWheel<double> command_m_s =
      random.chance(0.6) ? PerWheel<double>{speed_m_s, speed_m_s} : PerWheel<double>{-speed_m_s, speed_m_s};
  if (random.chance(0.5))
    append_hold(programme, limits, command_m_s, random.uniform(1.0, 2.0));
  else
    append_ramp(programme, limits, {0.0, 0.0}, command_m_s, random.uniform(1.5, 3.0));
}

}  // namespace

void append_hold(Programme& programme, const ProgrammeLimits& limits, PerWheel<double> command_m_s,
                 double duration_s) {
  programme.insert(programme.end(), static_cast<std::size_t>(row_count(limits, duration_s)), command_m_s);
}

void append_ramp(Programme& programme, const ProgrammeLimits& limits, PerWheel<double> from_m_s,
                 PerWheel<double> to_m_s, double duration_s) {
  const int rows = row_count(limits, duration_s);
  for (int row = 1; row <= rows; ++row) {
    const double share = static_cast<double>(row) / rows;
    programme.push_back({std::lerp(from_m_s[left_side], to_m_s[left_side], share),
                         std::lerp(from_m_s[right_side], to_m_s[right_side], share)});
  }
}

Programme rich_manoeuvre(const ProgrammeLimits& limits, Random& random) {
  Programme part;
  const double dice = random.uniform(0.0, 1.0);
  if (dice < 0.18) {
    const double speed_m_s = random_speed_m_s(limits, random);
    append_hold(part, limits, {speed_m_s, speed_m_s}, random.uniform(0.8, 3.0));
  } else if (dice < 0.40) {
    append_hold(part, limits, arc_speeds(limits, random), random.uniform(0.8, 3.0));
  } else if (dice < 0.52) {
    append_hold(part, limits, independent_speeds(limits, random), random.uniform(0.6, 2.0));
  } else if (dice < 0.66) {
    append_hold(part, limits, pivot_speeds(limits, random), random.uniform(0.6, 2.0));
  } else if (dice < 0.76) {
    append_ramp(part, limits, independent_speeds(limits, random), independent_speeds(limits, random),
                random.uniform(1.5, 4.0));
  } else if (dice < 0.82) {
    append_hold(part, limits, {0.0, 0.0}, random.uniform(0.5, 1.5));
  } else if (dice < 0.89) {
    append_sine(part, limits, random);
  } else {
    append_creeping(part, limits, random);
  }
  return part;
}

Programme bold_manoeuvre(const ProgrammeLimits& limits, double smallest_m_s, Random& random) {
  Programme part;
  const auto speed_m_s = [&] { return random.sign() * random.uniform(smallest_m_s, limits.fastest_m_s); };
  const double straight_m_s = speed_m_s();
  const double dice = random.uniform(0.0, 1.0);
  if (dice < 0.4)
    append_hold(part, limits, {straight_m_s, straight_m_s}, random.uniform(0.8, 2.5));
  else if (dice < 0.6)
    append_hold(part, limits, {-straight_m_s, straight_m_s}, random.uniform(0.4, 1.0));
  else if (dice < 0.85)
    append_hold(part, limits, {speed_m_s(), speed_m_s()}, random.uniform(0.4, 1.2));
  else
    append_hold(part, limits, {0.0, 0.0}, random.uniform(0.5, 1.5));
  return part;
}

}  // namespace plants::second
