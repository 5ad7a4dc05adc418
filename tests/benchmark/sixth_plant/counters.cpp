#include "tests/benchmark/sixth_plant/counters.hpp"

#include <algorithm>
#include <cmath>

#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

Counters::Counters(const Robot& robot, const Hidden& hidden, double duration_s, Random& chance,
                   Random& measuring)
    : metres_per_tick_(robot.metres_per_tick), first_ticks_{unit(measuring), unit(measuring)} {
  const double share = hidden[Effect::encoder_dropout];
  if (share == 0.0) return;
  // Long enough to be seen between two rows.
  const double usual_s = std::max(std::clamp(6 * share, 0.08, 0.5), 3 * robot.period_s);
  const int count = std::max(4, static_cast<int>(std::lround(share * duration_s / usual_s)));
  for (int index = 0; index < count; ++index) {
    const double from_s = 2 + (duration_s - 4) * (index + chance.uniform(0.1, 0.9)) / count;
    gaps_.push_back({from_s, from_s + usual_s * chance.uniform(0.6, 1.6), hidden.details.heads()});
  }
}

bool Counters::dead(std::size_t side, double time_s) const {
  return std::ranges::any_of(gaps_, [=](const Gap& gap) {
    return time_s >= gap.from_s && time_s < gap.to_s && (side == left_side || !gap.left_only);
  });
}

void Counters::step(double time_s, const PerWheel<double>& rim_m_s) {
  for (const std::size_t side : {left_side, right_side})
    if (!dead(side, time_s)) counted_m_[side] += rim_m_s[side] * fine_step_s;
}

PerWheel<long> Counters::ticks(const PerWheel<double>& counted_m) const {
  PerWheel<long> ticks{};
  for (const std::size_t side : {left_side, right_side})
    ticks[side] = static_cast<long>(std::floor(counted_m[side] / metres_per_tick_ + first_ticks_[side]));
  return ticks;
}

}  // namespace plants::sixth
