// Numbers as text, in sentences.
#pragma once

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace wheelwright {

// With so many significant digits, without zeros at the end. From 0.0001 up to a million as a person writes
// it: 2430, not 2.43e+03.
inline std::string in_digits(double value, int digits) {
  if (value == 0.0) return "0";  // and not -0
  std::ostringstream text;
  const double unit = std::isfinite(value)
                          ? std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - digits)
                          : 0.0;  // of the last digit
  const double rounded = unit >= 1.0 ? unit * std::round(value / unit) : value;
  if (unit >= 1.0 && std::abs(rounded) < 1e6) {
    text << std::fixed << std::setprecision(0) << rounded;
  } else {
    text << std::setprecision(digits) << value;
  }
  return text.str();
}

}  // namespace wheelwright
