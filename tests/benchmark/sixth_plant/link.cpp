#include "tests/benchmark/sixth_plant/link.hpp"

#include <algorithm>

namespace plants::sixth {

Link::Link(const Robot& robot, const Hidden& hidden, const DriveScript& script, Random& chance)
    : script_(script), latency_s_(robot.latency_s), buffered_s_(hidden[Effect::transport_delay]) {
  if (!hidden.has(Effect::link_stalls)) return;
  for (double from_s = chance.uniform(1, 3); from_s < script.time_s.back();) {
    const double lasts_s = hidden[Effect::link_stalls] * chance.uniform(0.6, 1.4);
    stalls_.push_back({from_s, from_s + lasts_s});
    from_s += lasts_s + chance.uniform(1.0, 3.5);
  }
}

bool Link::stalls(double time_s) const {
  return std::ranges::any_of(
      stalls_, [time_s](const Stall& stall) { return time_s >= stall.from_s && time_s < stall.to_s; });
}

const PerWheel<double>& Link::command_m_s(double time_s) {
  while (next_ < script_.time_s.size() && script_.time_s[next_] + latency_s_ + buffered_s_ <= time_s + 1e-9 &&
         !stalls(time_s))
    held_m_s_ = script_.command_m_s[next_++];
  return held_m_s_;
}

}  // namespace plants::sixth
