// When to try again to open a port that is gone: soon at first, then less often.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wheelwright::roomba {

class ReopenSchedule {
 public:
  explicit ReopenSchedule(double period_s) : period_s_(period_s) {}

  // The port was closed at this tick.
  void closed(std::int64_t tick) { try_again_after(tick, shortest_s); }
  bool due(std::int64_t tick) const { return tick >= at_tick_; }
  // It could not be opened at this tick.
  void failed(std::int64_t tick) { try_again_after(tick, std::min(2.0 * wait_s_, longest_s)); }

 private:
  static constexpr double shortest_s = 0.1;
  static constexpr double longest_s = 0.5;

  void try_again_after(std::int64_t tick, double wait_s) {
    wait_s_ = wait_s;
    at_tick_ = tick + std::llround(wait_s / period_s_);
  }

  double period_s_;
  double wait_s_ = shortest_s;
  std::int64_t at_tick_ = 0;
};

}  // namespace wheelwright::roomba
