// Confidence intervals.
#pragma once

namespace wheelwright {

// Standard deviations from the middle of a normal distribution to each end of the interval that holds 95 %.
inline constexpr double deviations_in_ci95 = 1.96;

}  // namespace wheelwright
