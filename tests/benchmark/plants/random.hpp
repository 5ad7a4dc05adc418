#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace plants {

// Small deterministic generator (splitmix64): the same numbers with every compiler and library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 0x1234567ULL) {}

  // An independent stream; the parent is not advanced, so that adding a child shifts nothing.
  [[nodiscard]] Random child(std::uint64_t index) const {
    Random mixer(state_ ^ (0xD1B54A32D192ED03ULL * (index + 1)));
    return Random(mixer.bits());
  }

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  double uniform(double low, double high) {
    const double unit = static_cast<double>(bits() >> 11) * 0x1.0p-53;
    return low + (high - low) * unit;
  }

  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }

  double signed_uniform(double low, double high) {
    const double side = sign();
    return side * uniform(low, high);
  }

  double normal(double sigma) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return sigma * radius * std::cos(2.0 * std::numbers::pi * uniform(0.0, 1.0));
  }

  int integer(int low, int high) { return low + static_cast<int>(uniform(0.0, high - low + 1.0)); }

  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  double sign() { return chance(0.5) ? 1.0 : -1.0; }

 private:
  std::uint64_t state_;
};

}  // namespace plants
