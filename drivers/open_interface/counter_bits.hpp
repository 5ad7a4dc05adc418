// Bits of an encoder's counts that stay at the same level while the wheel passes through all their values:
// the line loses them (line_bits.hpp), and the travel that such counts give is wrong.
//
// Judges bits 5 and 6. They change every 32 and 64 ticks, which no wheel steps over from one sample to the
// next. A lost bit 7 makes steps that no wheel can make: EncoderCounter refuses those.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace wheelwright::open_interface {

class CounterBits {
 public:
  // Takes a count, and the change since the one before.
  void take(std::uint16_t raw, int change) {
    if (std::abs(change) > max_step) forget();
    travel_ += change;
    lowest_ = std::min(lowest_, travel_);
    highest_ = std::max(highest_, travel_);
    ever_set_ |= raw;
    always_set_ &= raw;
  }

  // After a reset of the counter.
  void forget() { *this = CounterBits{}; }

  // The bits that never changed, 0 as long as the wheel has not gone far enough in one direction to say so.
  unsigned stuck() const {
    if (highest_ - lowest_ < enough_travel) return 0;
    return (~ever_set_ | always_set_) & judged;
  }

 private:
  static constexpr int max_step = 96;  // ticks a sample; beyond, bits may change and change back between two
  static constexpr int enough_travel = 512;  // twice what the low byte counts
  static constexpr unsigned judged = 0x60;

  int travel_ = 0;
  int lowest_ = 0;
  int highest_ = 0;
  unsigned ever_set_ = 0;
  unsigned always_set_ = 0xFFFF;
};

}  // namespace wheelwright::open_interface
