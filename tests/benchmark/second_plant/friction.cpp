#include "tests/benchmark/second_plant/friction.hpp"

#include <cmath>

namespace plants::second {

double Friction::force_n(double speed_m_s, double step_s) {
  if (spec_.breakaway_n <= 0.0) return 0.0;
  const double relative = speed_m_s / spec_.stribeck_speed_m_s;
  const double sliding_n =
      spec_.coulomb_n + (spec_.breakaway_n - spec_.coulomb_n) * std::exp(-relative * relative);
  const double stiffness_n_m = spec_.breakaway_n / spec_.bristle_travel_m;
  const double damping_n_s_m = 0.5 * std::sqrt(stiffness_n_m) * std::exp(-relative * relative);

  // Implicit in the deflection: the bristles relax much faster than one step when sliding fast.
  const double previous_m = deflection_m_;
  const double relaxation_1_s = stiffness_n_m * std::abs(speed_m_s) / sliding_n;
  deflection_m_ = (previous_m + step_s * speed_m_s) / (1.0 + step_s * relaxation_1_s);
  return stiffness_n_m * deflection_m_ + damping_n_s_m * (deflection_m_ - previous_m) / step_s;
}

}  // namespace plants::second
