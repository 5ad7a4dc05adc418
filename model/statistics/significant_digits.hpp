// Numbers as text, in sentences.
#pragma once

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace wheelwright {

// With so many significant digits, without zeros at the end; below a million as a person writes it: 2430, not
// 2.43e+03.
inline std::string in_digits(double value, int digits) {
  std::ostringstream text;
  const double magnitude = std::abs(value);
  const int before_point = magnitude >= 1.0 ? static_cast<int>(std::floor(std::log10(magnitude))) + 1 : 1;
  if (before_point >= digits && magnitude < 1e6) {
    const double unit = std::pow(10.0, before_point - digits);
    text << std::fixed << std::setprecision(0) << unit * std::round(value / unit);
  } else {
    text << std::setprecision(digits) << value;
  }
  return text.str();
}

}  // namespace wheelwright
