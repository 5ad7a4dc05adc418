#include "drivers/simulation/misread_byte.hpp"

#include <cmath>

namespace wheelwright::simulation {
namespace {

// The line `at` so many of the sender's bits after the byte began.
bool level(std::uint8_t sent, double at) {
  const int bit = static_cast<int>(std::floor(at));
  if (bit < 1) return false;
  if (bit > 8) return true;
  return ((static_cast<unsigned>(sent) >> static_cast<unsigned>(bit - 1)) & 1U) != 0;
}

}  // namespace

std::size_t misread(std::uint8_t sent, double ratio, std::span<std::uint8_t, max_misread> out) {
  constexpr double bits = 10.0;
  const double step = ratio;  // one of the receiver's bits, in those of the sender
  std::size_t count = 0;
  double at = 0.0;
  while (at < bits && count < out.size()) {
    if (level(sent, at)) {  // the next fall is at the beginning of one of the sender's bits
      at = std::floor(at) + 1.0;
      continue;
    }
    unsigned value = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      value |= level(sent, at + (1.5 + bit) * step) ? 1U << bit : 0U;
    }
    const bool framed = level(sent, at + 9.5 * step);
    at += 9.5 * step;
    if (framed) {
      out[count++] = static_cast<std::uint8_t>(value);
    } else {
      while (at < bits && !level(sent, at)) at = std::floor(at) + 1.0;  // wait for the line to rise
    }
  }
  return count;
}

}  // namespace wheelwright::simulation
