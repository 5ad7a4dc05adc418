#include "model/gap/adequacy/heading_swing.hpp"

#include <algorithm>
#include <cstddef>

#include "model/gap/adequacy/swing_amplitude.hpp"

namespace wheelwright::gap {

double heading_swing_rad(const FitProblem& problem, const PeriodicResidual& found,
                         std::span<const ResidualTrack* const> left,
                         std::span<const ResidualTrack* const> right,
                         std::span<const std::vector<double>> at) {
  if (left.size() != right.size() || left.size() != at.size()) return 0.0;
  SwingAmplitude swing(found.period);
  double by_a_count_rad = 0.0;
  for (std::size_t t = 0; t < left.size(); ++t) {
    const ResidualTrack& one = *left[t];
    const ResidualTrack& other = *right[t];
    if (one.run != other.run || one.time_s != other.time_s || at[t].size() != one.error.size()) return 0.0;
    const WheelPair& tick_m = problem.metres_per_tick(one.run);
    by_a_count_rad =
        std::max(by_a_count_rad, 0.5 * (tick_m.left + tick_m.right) / problem.runs()[one.run].wheel_base_m);
    std::vector<double> heading_rad;
    for (std::size_t k = 0; k < one.error.size(); ++k)
      heading_rad.push_back((other.error[k] - one.error[k]) / problem.runs()[one.run].wheel_base_m);
    swing.add(heading_rad, at[t], one.discontinuity);
  }
  const double amplitude = swing.amplitude();
  return amplitude > by_a_count_rad ? amplitude : 0.0;
}

}  // namespace wheelwright::gap
