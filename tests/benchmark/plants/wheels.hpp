#pragma once

#include <array>
#include <cstddef>

namespace plants {

inline constexpr std::size_t left_side = 0;
inline constexpr std::size_t right_side = 1;
inline constexpr std::size_t wheel_count = 2;

template <class T>
using PerWheel = std::array<T, wheel_count>;

}  // namespace plants
