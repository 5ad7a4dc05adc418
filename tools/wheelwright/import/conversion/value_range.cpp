#include "tools/wheelwright/import/conversion/value_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelwright::import {

ValueRange range_of(std::span<const double> values) {
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
  }
  return range;
}

}  // namespace wheelwright::import
