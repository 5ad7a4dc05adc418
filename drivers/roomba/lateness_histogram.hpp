// How late a loop woke up: a histogram of fixed size, filled without allocation.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace wheelwright::roomba {

class LatenessHistogram {
 public:
  void add(std::chrono::nanoseconds lateness);

  std::uint64_t count() const { return count_; }
  std::chrono::nanoseconds largest() const { return largest_; }
  // The lateness that a share of all wake-ups (0 to 1) stayed below; to about 4 %.
  std::chrono::nanoseconds quantile(double share) const;

  // The bins themselves, from early to late; no lateness in a bin is larger than its upper edge.
  static constexpr std::size_t bins = 512;
  std::uint32_t in_bin(std::size_t bin) const { return bins_.at(bin); }
  static std::chrono::nanoseconds upper_edge(std::size_t bin);

 private:
  std::array<std::uint32_t, bins> bins_{};
  std::uint64_t count_ = 0;
  std::chrono::nanoseconds largest_{0};
};

}  // namespace wheelwright::roomba
