#pragma once

#include <cstdint>

#include "tests/benchmark/plants/random.hpp"

namespace plants::sixth {

// The shared generator from its fifth number on: the figures for this robot were published with it.
inline Random warmed_up(std::uint64_t seed) {
  Random random(seed);
  for (int skipped = 0; skipped < 4; ++skipped) random.bits();
  return random;
}

inline std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t index) {
  return warmed_up(seed ^ (index * 0xD6E8FEB86659FD93ULL)).bits();
}

inline double unit(Random& random) {
  return random.uniform(0.0, 1.0);
}

// Nearly normal with variance one: the sum of eight uniform numbers, which costs no logarithm in each fine
// step.
inline double bell(Random& random) {
  constexpr double middle = 4.0;
  constexpr double half_steps = 8 * 0.5 / 65536;
  constexpr double one_over_sigma = 1.2247448713915890;
  double sum = 0.0;
  for (int word = 0; word < 2; ++word) {
    const std::uint64_t bits = random.bits();
    sum += static_cast<double>(bits & 0xffff) + static_cast<double>((bits >> 16) & 0xffff) +
           static_cast<double>((bits >> 32) & 0xffff) + static_cast<double>(bits >> 48);
  }
  return (sum / 65536.0 - middle + half_steps) * one_over_sigma;
}

}  // namespace plants::sixth
