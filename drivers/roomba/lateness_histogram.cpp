#include "drivers/roomba/lateness_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::roomba {
namespace {

// Bins grow by a constant ratio from 100 ns on; 512 of them reach beyond a minute.
constexpr double first_bin_ns = 100.0;
constexpr std::size_t octave = 17;
constexpr auto bins_per_octave = static_cast<double>(octave);

}  // namespace

void LatenessHistogram::add(std::chrono::nanoseconds lateness) {
  const auto ns = static_cast<double>(std::max<std::int64_t>(lateness.count(), 0));
  const double position = ns <= first_bin_ns ? 0.0 : 1.0 + bins_per_octave * std::log2(ns / first_bin_ns);
  const auto bin = std::min(static_cast<std::size_t>(position), bins - 1);
  bins_.at(bin).add();
  count_.add();
  largest_ns_.set(std::max<std::int64_t>(largest_ns_.value(), lateness.count()));
}

std::chrono::nanoseconds LatenessHistogram::upper_edge(std::size_t bin) {
  const double edge_ns = first_bin_ns * std::exp2(static_cast<double>(bin) / bins_per_octave);
  return std::chrono::nanoseconds(static_cast<std::int64_t>(edge_ns));
}

std::chrono::nanoseconds LatenessHistogram::quantile(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count())));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    seen += in_bin(bin);
    if (seen < wanted || seen == 0) continue;
    if (bin + 1 == bins) break;  // has no upper end
    return std::min(largest(), upper_edge(bin));
  }
  return largest();
}

std::vector<LatenessStep> coarse(const LatenessHistogram& histogram) {
  std::vector<LatenessStep> steps;
  LatenessStep step{{}, 0};
  for (std::size_t bin = 0; bin < LatenessHistogram::bins; ++bin) {
    step.count += histogram.in_bin(bin);
    if (bin % octave != 0 && bin + 1 != LatenessHistogram::bins) continue;
    step.upper_edge = LatenessHistogram::upper_edge(bin);
    if (step.count > 0 || !steps.empty()) steps.push_back(step);
    step.count = 0;
  }
  while (!steps.empty() && steps.back().count == 0) steps.pop_back();
  return steps;
}

}  // namespace wheelwright::roomba
