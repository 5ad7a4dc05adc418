// Something that may happen thousands of times a second and is to be said: the first time at once, and after
// that once a period, with the number of times.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace wheelwright::daemon::telemetry {

class CountedNotice {
 public:
  using Clock = std::chrono::steady_clock;

  explicit CountedNotice(Clock::duration period) : period_(period) {}

  // It has happened. Returns true where that is to be said at once.
  bool happened(Clock::time_point now) {
    // Where due() was not asked in time, it says this one together with those before it.
    if (unsaid_ > 0 || (last_said_ && now - *last_said_ < period_)) {
      ++unsaid_;
      return false;
    }
    last_said_ = now;
    return true;
  }

  // How often it has happened since it was said last, where the period is over; call it now and then.
  std::optional<std::uint64_t> due(Clock::time_point now) {
    if (unsaid_ == 0 || now - *last_said_ < period_) return std::nullopt;
    last_said_ = now;
    return take_unsaid();
  }

  // The same before the period is over, at the end.
  std::optional<std::uint64_t> rest() {
    if (unsaid_ == 0) return std::nullopt;
    return take_unsaid();
  }

 private:
  std::uint64_t take_unsaid() {
    const std::uint64_t count = unsaid_;
    unsaid_ = 0;
    return count;
  }

  Clock::duration period_;
  std::optional<Clock::time_point> last_said_;
  std::uint64_t unsaid_ = 0;
};

}  // namespace wheelwright::daemon::telemetry
