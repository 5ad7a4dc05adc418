#include "tests/benchmark/third_plant/friction.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

double Friction::force_n(double speed_m_s, double step_s) {
  if (spec_.coulomb_n == 0.0 && spec_.breakaway_n == 0.0) return 0.0;
  if (spec_.regularised_m_s > 0.0) return spec_.coulomb_n * std::tanh(speed_m_s / spec_.regularised_m_s);
  return bristle_force_n(speed_m_s, step_s);
}

double Friction::bristle_force_n(double speed_m_s, double step_s) {
  constexpr double damping_ratio = 0.7;
  const double largest_n = std::max(spec_.coulomb_n, spec_.breakaway_n);
  const double stiffness_n_m = largest_n / spec_.bristle_travel_m;
  const double stribeck = speed_m_s / spec_.stribeck_m_s;
  const double steady_n = spec_.coulomb_n + (largest_n - spec_.coulomb_n) * std::exp(-stribeck * stribeck);

  // Implicit, because bristles that slide relax within much less than a step.
  const double before_m = deflection_m_;
  deflection_m_ =
      (before_m + step_s * speed_m_s) / (1.0 + step_s * std::abs(speed_m_s) * stiffness_n_m / steady_n);
  const double bending_m_s = (deflection_m_ - before_m) / step_s;
  return stiffness_n_m * deflection_m_ +
         damping_ratio * std::sqrt(stiffness_n_m * rim_mass_kg_) * bending_m_s;
}

}  // namespace plants::third
