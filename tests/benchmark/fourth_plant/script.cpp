#include "tests/benchmark/fourth_plant/script.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fourth {

namespace {

// What the command message resolves, and the log too.
double as_sent(double speed_m_s) {
  constexpr double resolution_m_s = 1.0e-4;
  return resolution_m_s * std::round(speed_m_s / resolution_m_s);
}

}  // namespace

void Script::add(double forward_m_s, double turn_rad_s) {
  forward_m_s_ = forward_m_s;
  turn_rad_s_ = turn_rad_s;
  const double half_difference_m_s = 0.5 * limits_.wheel_base_m * turn_rad_s;
  const double fastest_m_s = std::abs(forward_m_s) + std::abs(half_difference_m_s);
  const double scale = std::min(1.0, limits_.fastest_m_s / std::max(fastest_m_s, 1.0e-9));
  commands_.push_back({as_sent(scale * (forward_m_s - half_difference_m_s)),
                       as_sent(scale * (forward_m_s + half_difference_m_s))});
}

void Script::hold(double forward_m_s, double turn_rad_s, double for_s) {
  const double end_s = std::min(duration_s_, time_s() + for_s);
  while (time_s() < end_s) add(forward_m_s, turn_rad_s);
}

void Script::ramp(double forward_m_s, double turn_rad_s, double for_s) {
  const double start_s = time_s();
  const double from_m_s = forward_m_s_;
  const double from_rad_s = turn_rad_s_;
  while (time_s() < std::min(duration_s_, start_s + for_s)) {
    const double share = (time_s() - start_s) / for_s;
    add(from_m_s + share * (forward_m_s - from_m_s), from_rad_s + share * (turn_rad_s - from_rad_s));
  }
}

}  // namespace plants::fourth
