#include "tests/benchmark/fifth_plant/encoders.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

Encoders::Encoders(const EncoderSpec& spec, double radius_m, const Random& random)
    : spec_(spec), radius_m_(radius_m), random_(random) {
  // A counter starts anywhere within a tick.
  for (double& counted_m : counted_m_) counted_m = random_.uniform(0.0, spec_.metres_per_tick);
  if (spec_.dropout_every_s > 0.0) loose_from_s_ = random_.uniform(0.2, 1.0) * spec_.dropout_every_s;
}

bool Encoders::connected() {
  if (time_s_ > loose_from_s_ + spec_.dropout_s) {
    loose_from_s_ += spec_.dropout_every_s * random_.uniform(0.6, 1.4);
    loose_wheel_ = random_.chance(0.5) ? left_side : right_side;
  }
  return time_s_ < loose_from_s_;
}

// Fast edges of the left channel are coupled into the right one where that one turns, too.
void Encoders::step(const PerWheel<double>& shaft_rad_s) {
  constexpr double turning_m_s = 0.02;
  const bool all_connected = connected();
  const double left_m_s = radius_m_ * std::abs(shaft_rad_s[left_side]);
  for (const std::size_t wheel : {left_side, right_side}) {
    const double own_m_s = radius_m_ * shaft_rad_s[wheel];
    double seen_m_s = own_m_s;
    if (wheel == right_side && std::abs(own_m_s) > turning_m_s)
      seen_m_s +=
          std::copysign(spec_.crosstalk * std::max(0.0, left_m_s - spec_.crosstalk_from_m_s), own_m_s);
    if (all_connected || wheel != loose_wheel_) counted_m_[wheel] += fine_step_s * seen_m_s;
  }
  time_s_ += fine_step_s;
}

PerWheel<long> Encoders::ticks() const {
  const auto counted = [this](std::size_t wheel) {
    return static_cast<long>(std::floor(counted_m_[wheel] / spec_.metres_per_tick));
  };
  return {counted(left_side), counted(right_side)};
}

}  // namespace plants::fifth
