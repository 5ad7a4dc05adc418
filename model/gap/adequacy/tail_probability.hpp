// Tail of the chi-squared distribution.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright::gap {

// P(X >= value) for X chi-squared with so many degrees of freedom, by the cube root's approximation to the
// normal distribution (Wilson and Hilferty, PNAS 17 (1931) 684-688); good to a tenth of itself down to
// 1e-6.
inline double chi_squared_tail(double value, double degrees) {
  const double spread = 2.0 / (9.0 * degrees);
  const double z = (std::cbrt(std::max(value, 0.0) / degrees) - (1.0 - spread)) / std::sqrt(spread);
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

// Of the smallest of so many independent p-values.
inline double smallest_of(double p_value, double count) {
  return p_value < 1e-8 ? std::min(1.0, p_value * count)
                        : 1.0 - std::pow(1.0 - std::min(p_value, 1.0), count);
}

}  // namespace wheelwright::gap
