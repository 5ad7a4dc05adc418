// How late a loop woke up: a histogram of fixed size, filled by one thread without allocation or lock. Any
// thread may read it meanwhile; what it reads may then be a wake-up or two apart.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drivers/roomba/loop_count.hpp"

namespace wheelwright::roomba {

class LatenessHistogram {
 public:
  void add(std::chrono::nanoseconds lateness);

  std::uint64_t count() const { return static_cast<std::uint64_t>(count_.value()); }
  std::chrono::nanoseconds largest() const { return std::chrono::nanoseconds(largest_ns_.value()); }
  // The lateness that a share of all wake-ups (0 to 1) stayed below; to about 4 %.
  std::chrono::nanoseconds quantile(double share) const;

  // The bins themselves, from early to late; no lateness in a bin is larger than its upper edge.
  static constexpr std::size_t bins = 512;
  std::uint64_t in_bin(std::size_t bin) const { return static_cast<std::uint64_t>(bins_.at(bin).value()); }
  static std::chrono::nanoseconds upper_edge(std::size_t bin);

 private:
  std::array<LoopCount, bins> bins_{};
  LoopCount count_;
  LoopCount largest_ns_;
};

// The same for people to read: steps that double, from the first to the last that holds a wake-up.
struct LatenessStep {
  std::chrono::nanoseconds upper_edge;
  std::uint64_t count;
};
std::vector<LatenessStep> coarse(const LatenessHistogram& histogram);

}  // namespace wheelwright::roomba
