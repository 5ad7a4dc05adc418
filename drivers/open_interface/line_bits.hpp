// Which bits of a byte the line passes: an adapter that is set to seven data bits, or broken, holds one at
// the same level in every byte.
//
// A sound robot's bytes set and clear each bit. Most of its sensors are zero, which clears all. Without a
// charger its current is negative, so that the first byte of packet 23 is 255, which sets all.
#pragma once

#include <cstdint>

namespace wheelwright::open_interface {

class LineBits {
 public:
  void take(std::uint8_t byte) {
    ever_set_ |= byte;
    always_set_ &= byte;
    ++bytes_;
  }

  std::uint64_t bytes() const { return bytes_; }
  // One bit each, as in the bytes themselves; all of them as long as there were no bytes.
  std::uint8_t never_set() const { return static_cast<std::uint8_t>(~ever_set_); }
  std::uint8_t always_set() const { return always_set_; }

 private:
  std::uint8_t ever_set_ = 0;
  std::uint8_t always_set_ = 0xFF;
  std::uint64_t bytes_ = 0;
};

}  // namespace wheelwright::open_interface
