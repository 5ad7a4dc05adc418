// Numbers as text, in sentences.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace wheelwright {

// With so many significant digits, without zeros at the end.
inline std::string in_digits(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

}  // namespace wheelwright
