// What a person sees in a plot of a free run; a smaller error is no gap.
#pragma once

namespace wheelwright::gap {

constexpr double visible_travel_m = 0.003;  // of a wheel
constexpr double visible_position_m = 0.006;
constexpr double visible_heading_rad = 0.010;

}  // namespace wheelwright::gap
