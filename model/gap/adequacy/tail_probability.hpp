// Tails of the chi-squared and the Poisson distribution.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelwright::gap {

// P(X >= value) for X chi-squared with so many degrees of freedom: by the recurrence of the incomplete gamma
// function, Q(k + 2) = Q(k) + (value / 2)^(k / 2) exp(-value / 2) / Gamma(k / 2 + 1), from Q(1) and Q(2).
inline double chi_squared_tail(double value, int degrees) {
  const double half = 0.5 * std::max(value, 0.0);
  if (half == 0.0) return 1.0;
  const bool is_even = degrees % 2 == 0;
  double tail = is_even ? std::exp(-half) : std::erfc(std::sqrt(half));
  for (int k = is_even ? 2 : 1; k < degrees; k += 2) {
    tail += std::exp(0.5 * k * std::log(half) - half - std::lgamma(0.5 * k + 1.0));
  }
  return std::min(tail, 1.0);
}

// P(N >= count) for N Poisson with this mean, from the terms themselves, so that small ones are exact.
inline double poisson_tail(std::size_t count, double mean) {
  const auto k = static_cast<double>(count);
  double term = std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
  double sum = 0.0;
  for (double next = k + 1.0; term > 1e-17 * sum; ++next) {
    sum += term;
    term *= mean / next;
  }
  return std::min(sum, 1.0);
}

// Of the smallest of so many independent p-values.
inline double smallest_of(double p_value, double count) {
  return p_value < 1e-8 ? std::min(1.0, p_value * count)
                        : 1.0 - std::pow(1.0 - std::min(p_value, 1.0), count);
}

}  // namespace wheelwright::gap
