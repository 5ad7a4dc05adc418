#include "tools/wheelwright/import/columns/column_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright::import {

double evenness(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (std::isfinite(step)) steps.push_back(step);
  }
  if (steps.size() + 10 < values.size() || steps.size() < 2) return 0.0;
  const auto at = [&](double share) { return quantile(steps, share); };
  return at(0.02) > 0.0 ? at(0.1) / at(0.9) : 0.0;
}

bool is_row_index(const std::vector<double>& values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] - values[i - 1] != 1.0) return false;
  }
  return values.size() > 1;
}

bool are_whole(const std::vector<double>& values) {
  return std::ranges::all_of(
      values, [](double value) { return !std::isfinite(value) || value == std::round(value); });
}

bool looks_counted(const std::vector<double>& values) {
  constexpr double min_range = 10.0;
  std::size_t changes = 0;
  std::size_t by_one = 0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  double last = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(last) && value != last) {
      ++changes;
      if (std::abs(value - last) == 1.0) ++by_one;
    }
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    last = value;
  }
  return highest - lowest >= min_range && by_one * 10 > changes * 8;
}

double quantum(const std::vector<double>& values) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (std::isfinite(value)) sorted.push_back(value);
  }
  std::ranges::sort(sorted);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    if (step > 1e-6 * std::abs(sorted.back() - sorted.front())) smallest = std::min(smallest, step);
  }
  return smallest;
}

bool is_held(const std::vector<double>& values) {
  constexpr double max_changes = 0.3;  // of the rows
  std::size_t changes = 0;
  std::size_t count = 0;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (count > 0 && value != last) ++changes;
    last = value;
    ++count;
  }
  return changes > 0 && static_cast<double>(changes) < max_changes * static_cast<double>(count);
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) result = std::max(result, std::abs(value));
  }
  return result;
}

}  // namespace wheelwright::import
