// Median and quantiles of values in any order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wheelwright {

// The value at place floor(share (n - 1)) of the n sorted values, share in [0, 1]: always one of them. Of no
// values it is undefined.
inline double quantile(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

// Of an even number of values the upper one of the two in the middle. Of no values it is undefined.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Median size, times this, is the standard deviation of a normal distribution.
inline constexpr double deviations_of_median_size = 1.4826;

}  // namespace wheelwright
