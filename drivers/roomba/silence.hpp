// What happened since the last sound reading: whether the machine was late, or the robot's replies did not
// come.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "drivers/open_interface/query_reader.hpp"

namespace wheelwright::roomba {

struct Silence {
  std::int64_t skipped_periods = 0;
  std::chrono::nanoseconds largest_lateness{};  // of the loop's wake-ups
  open_interface::ReplyCounts replies;          // with the transport query
};

class SilenceWatch {
 public:
  void woke_up(std::chrono::nanoseconds lateness) {
    largest_lateness_ = std::max(largest_lateness_, lateness);
  }

  void received(std::int64_t skipped_periods, const open_interface::ReplyCounts& replies) {
    begin_ = {skipped_periods, {}, replies};
    largest_lateness_ = {};
  }

  Silence until(std::int64_t skipped_periods, const open_interface::ReplyCounts& replies) const {
    const auto& before = begin_.replies;
    return {skipped_periods - begin_.skipped_periods,
            largest_lateness_,
            {replies.asked - before.asked, replies.sound - before.sound, replies.missing - before.missing,
             replies.incomplete - before.incomplete, replies.garbled - before.garbled,
             replies.stray_bytes - before.stray_bytes}};
  }

 private:
  Silence begin_;  // the counts at the last sound reading
  std::chrono::nanoseconds largest_lateness_{};
};

}  // namespace wheelwright::roomba
