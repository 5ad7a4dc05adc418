// How long an unknown past matters, and when a wheel is taken to move: what fits of a response share.
#pragma once

#include <cstddef>

namespace wheelwright {

// Wheels settle within 15 to 20 periods; after three times that, an unknown past has faded to nothing.
inline constexpr std::size_t forgetting_periods = 60;
// A wheel that was commanded within so many periods is taken to move.
inline constexpr double moving_window_periods = 6.0;
// Commands that differ by less are one.
inline constexpr double same_command_m_s = 1e-4;

}  // namespace wheelwright
