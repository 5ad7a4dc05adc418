// A free run that begins in the middle of a drive.
#pragma once

#include <cstdint>

namespace wheelwright {

inline constexpr double settle_s = 1.5;  // until the free run has forgotten that it began at rest
inline constexpr std::int64_t max_ticks_left_out = 200;

}  // namespace wheelwright
