// Whether counts that the link reports are counts that the robot had a moment ago.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace wheelwright::soak {

// One wheel. The link's counts differ from the robot's by a constant, from one new origin to the next: each
// sample bounds it, and a sample that contradicts those before is wrong.
class SampleCheck {
 public:
  // The robot's own count, once a millisecond.
  void note_true(std::int64_t counts) {
    recent_.at(next_) = counts;
    next_ = (next_ + 1) % recent_.size();
  }

  void new_origin() {
    lowest_ = std::numeric_limits<std::int64_t>::min();
    highest_ = std::numeric_limits<std::int64_t>::max();
  }

  // Whether `counts` is right. One that is not leaves the check as it was.
  bool agrees(std::int64_t counts) {
    const auto [least, most] = std::minmax_element(recent_.begin(), recent_.end());
    const std::int64_t lowest = std::max(lowest_, counts - *most);
    const std::int64_t highest = std::min(highest_, counts - *least);
    if (lowest > highest) return false;
    lowest_ = lowest;
    highest_ = highest;
    return true;
  }

 private:
  // As long as a reply can be old: a tick, a refresh of the sensors, and the bytes' time on the line.
  std::array<std::int64_t, 40> recent_{};
  std::size_t next_ = 0;
  std::int64_t lowest_ = std::numeric_limits<std::int64_t>::min();
  std::int64_t highest_ = std::numeric_limits<std::int64_t>::max();
};

}  // namespace wheelwright::soak
