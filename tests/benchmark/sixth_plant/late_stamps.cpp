#include "tests/benchmark/sixth_plant/late_stamps.hpp"

#include <algorithm>
#include <cmath>

namespace plants::sixth {

namespace {

constexpr double clock_set_every_s = 9.;

}  // namespace

LateStamps::LateStamps(const Hidden& hidden, Random& chance)
    : most_s_(hidden[Effect::stamp_sawtooth]), phase_s_(chance.uniform(0, clock_set_every_s)) {}

void LateStamps::remember(const Measurable& now) {
  if (most_s_ > 0.0) past_.push_back(now);
}

Measurable LateStamps::seen_at(double time_s, const Measurable& now) const {
  if (most_s_ == 0.0) return now;
  const double old_s = most_s_ * std::fmod(time_s + phase_s_, clock_set_every_s) / clock_set_every_s;
  const long index = static_cast<long>(past_.size()) - 1 - static_cast<long>(old_s * 1000);
  return past_[static_cast<std::size_t>(std::max(0L, index))];
}

}  // namespace plants::sixth
