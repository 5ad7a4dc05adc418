// Random numbers that are the same on every platform, which the distributions of the standard library are
// not.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace wheelwright {

class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  // Standard normal (Box and Muller 1958).
  double normal() {
    const double size = std::sqrt(-2.0 * std::log1p(-uniform()));
    return size * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace wheelwright
