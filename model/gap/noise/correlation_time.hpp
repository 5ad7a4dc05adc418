// How long residuals are correlated.
#pragma once

namespace wheelwright::gap {

// Sums of residuals over so long are taken for independent of each other.
constexpr double independent_after_s = 2.0;

}  // namespace wheelwright::gap
