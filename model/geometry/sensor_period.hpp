// How often a robot is read and commanded.
#pragma once

namespace wheelwright {

// Of the sensor loop where nobody states another: that of the paper, in which a Roomba's own 15 ms fit.
inline constexpr double default_period_s = 0.018;

}  // namespace wheelwright
