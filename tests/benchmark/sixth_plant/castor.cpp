#include "tests/benchmark/sixth_plant/castor.hpp"

#include <algorithm>
#include <cmath>

namespace plants::sixth {

double Castor::step(double largest_n_m, double forward_m_s, double turn_rad_s) {
  // Without it a fork that points straight ahead would never come round.
  constexpr double lean = 0.06;
  const double trail_m = robot_.castor_trail_m;
  const double cosine = std::cos(fork_rad_);
  const double sine = std::sin(fork_rad_);
  fork_rad_ += fine_step_s *
               (-(forward_m_s / trail_m) * sine - turn_rad_s * (1 + robot_.castor_arm_m / trail_m * cosine) +
                lean * hidden_.details.sign * std::abs(forward_m_s) / trail_m * cosine);
  const double wrong = -cosine * std::tanh(forward_m_s / 0.01);
  return wrong > 0 ? largest_n_m * sine * std::min(1., wrong * 3) : 0;
}

}  // namespace plants::sixth
