// What a set of offsets says: mean and standard deviation, each with a 95 % interval.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace wheelwright::tools {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

struct OffsetStatistics {
  double mean_m = 0.0;
  std::optional<double> standard_deviation_m;  // of one attempt, with n - 1; a single one shows none
  std::optional<Interval> mean_ci95_m;
  std::optional<Interval> standard_deviation_ci95_m;
};

// The intervals are by bootstrap over whole attempts, bias-corrected and accelerated (BCa; B. Efron, "Better
// bootstrap confidence intervals", J. Am. Stat. Assoc. 82 (1987) 171-185), since offsets are neither negative
// nor normal. Fewer than three attempts show none. The same offsets and seed give the
// same intervals. `offsets_m` holds at least one.
OffsetStatistics offset_statistics(std::span<const double> offsets_m, std::uint64_t seed);

}  // namespace wheelwright::tools
