#include "drivers/roomba/lateness_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::roomba {
namespace {

// Bins grow by a constant ratio from 100 ns on; 512 of them reach beyond a minute.
constexpr double first_bin_ns = 100.0;
constexpr double bins_per_octave = 17.0;

}  // namespace

void LatenessHistogram::add(std::chrono::nanoseconds lateness) {
  const auto ns = static_cast<double>(std::max<std::int64_t>(lateness.count(), 0));
  const double position = ns <= first_bin_ns ? 0.0 : 1.0 + bins_per_octave * std::log2(ns / first_bin_ns);
  const auto bin = std::min(static_cast<std::size_t>(position), bins - 1);
  ++bins_.at(bin);
  ++count_;
  largest_ = std::max(largest_, lateness);
}

std::chrono::nanoseconds LatenessHistogram::upper_edge(std::size_t bin) {
  const double edge_ns = first_bin_ns * std::exp2(static_cast<double>(bin) / bins_per_octave);
  return std::chrono::nanoseconds(static_cast<std::int64_t>(edge_ns));
}

std::chrono::nanoseconds LatenessHistogram::quantile(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    seen += bins_.at(bin);
    if (seen < wanted || seen == 0) continue;
    if (bin + 1 == bins) break;  // has no upper end
    return std::min(largest_, upper_edge(bin));
  }
  return largest_;
}

}  // namespace wheelwright::roomba
