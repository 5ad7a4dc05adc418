// A counter that was set to zero in mid-log: the board was started again, or a program cleared it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wheelwright::import {

// Where a travel of many steps falls to within a few steps of zero and goes on from there; not where a
// counter wraps, and not where a single value is zero.
std::vector<std::size_t> counter_resets(std::span<const double> travel);

}  // namespace wheelwright::import
