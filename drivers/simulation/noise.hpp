// Random numbers that are the same on every machine for the same seed (splitmix64, Steele et al. 2014).
#pragma once

#include <cstdint>

namespace wheelwright::simulation {

class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebULL;
    return mixed ^ (mixed >> 31U);
  }

  // In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

  // Mean 0, standard deviation 1: the sum of twelve uniform numbers, which is normal enough for sensors and
  // never throws a value beyond six.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  bool happens(double probability) { return probability > 0.0 && uniform() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace wheelwright::simulation
