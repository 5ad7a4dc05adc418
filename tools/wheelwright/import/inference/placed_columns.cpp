#include "tools/wheelwright/import/inference/placed_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/log/lost_poses.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_cleaned_columns = 12;

// Columns in which the poses that a tracker lost are not-a-number. Which two are x and y is not known: any
// two that say the same number there, and whatever does not change meanwhile.
std::vector<Channel> without_lost_poses(const std::vector<const Channel*>& columns) {
  std::vector<Channel> cleaned;
  cleaned.reserve(columns.size());
  for (const Channel* column : columns) cleaned.push_back(*column);
  for (std::size_t a = 0; a < columns.size(); ++a) {
    for (std::size_t b = a + 1; b < columns.size(); ++b) {
      const auto& x = columns[a]->values;
      for (const RowStretch& stretch : lost_stretches(x, columns[b]->values)) {
        for (Channel& each : cleaned) {
          const auto begin = each.values.begin() + static_cast<std::ptrdiff_t>(stretch.begin);
          const auto end = each.values.begin() + static_cast<std::ptrdiff_t>(stretch.end);
          if (std::all_of(begin, end, [&](double value) { return value == *begin; }))
            blank({&stretch, 1}, each.values);
        }
      }
    }
  }
  return cleaned;
}

// Not-a-number wherever a part is.
void blank_as(const std::vector<double>& part, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(part[i])) values[i] = part[i];
  }
}

}  // namespace

PlacedColumns placed_columns(const std::vector<const Channel*>& columns,
                             std::optional<QuaternionColumns>& quaternion) {
  PlacedColumns placed;
  if (columns.size() <= max_cleaned_columns) placed.cleaned = without_lost_poses(columns);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Channel* channel = placed.cleaned.empty() ? columns[k] : &placed.cleaned[k];
    if (quaternion && quaternion->has(columns[k])) {
      blank_as(channel->values, quaternion->heading_rad);
    } else {
      placed.unused.push_back(channel);
    }
  }
  return placed;
}

}  // namespace wheelwright::import
