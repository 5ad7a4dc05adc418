// The least and the largest of some values.
#pragma once

#include <span>

namespace wheelwright::import {

struct ValueRange {
  double least = 0.0;
  double most = 0.0;

  double size() const { return most - least; }
};

// Of those that are finite; infinite, the least above the largest, where none is.
ValueRange range_of(std::span<const double> values);

}  // namespace wheelwright::import
