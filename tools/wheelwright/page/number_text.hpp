// Numbers as a person reads them in a report.
#pragma once

#include <cmath>
#include <string>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {

// With about three digits that count.
inline std::string short_number(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 100.0 ? 0 : size >= 1.0 ? 2 : size >= 0.01 ? 4 : 6;
  return config::fixed_number(value, decimals);
}

inline std::string percent(double share) {
  return config::fixed_number(100.0 * share, 0) + " %";
}

}  // namespace wheelwright::tools
