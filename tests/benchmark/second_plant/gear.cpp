#include "tests/benchmark/second_plant/gear.hpp"

#include <algorithm>
#include <cmath>

namespace plants::second {

GearForces Gear::forces(double rotor_m_s, double wheel_m_s, double angle_from_high_rad, double step_s) {
  const double ratio = 1.0 + spec_.eccentricity * std::cos(angle_from_high_rad);
  const double twist_rate_m_s = rotor_m_s - wheel_m_s / ratio;
  twist_m_ += step_s * twist_rate_m_s;
  const double tooth_n = tooth_force_n(twist_rate_m_s);
  return {-tooth_n, tooth_n / ratio};
}

double Gear::tooth_force_n(double twist_rate_m_s) const {
  const double damping_n = spec_.damping_n_s_m * twist_rate_m_s;
  if (spec_.lash_m == 0.0) return spec_.stiffness_n_m * twist_m_ + damping_n;
  const double half_m = 0.5 * spec_.lash_m;
  // Teeth push but never pull.
  if (twist_m_ > half_m) return std::max(0.0, spec_.stiffness_n_m * (twist_m_ - half_m) + damping_n);
  if (twist_m_ < -half_m) return std::min(0.0, spec_.stiffness_n_m * (twist_m_ + half_m) + damping_n);
  return 0.0;
}

}  // namespace plants::second
