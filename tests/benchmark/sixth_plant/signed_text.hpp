#pragma once

#include <string>

#include "tests/benchmark/plants/text.hpp"

namespace plants::sixth {

// With the sign, whichever it is.
inline std::string signed_fixed(double value, int digits) {
  const std::string text = fixed(value, digits);
  return text.front() == '-' ? text : "+" + text;
}

inline std::string percent(double share, int digits) {
  return fixed(share * 100, digits);
}

}  // namespace plants::sixth
