#pragma once

#include <cmath>

namespace plants::third {

enum class RugShape { none, round, square };

// A rug, on which each wheel is by itself.
struct RugSpec {
  RugShape shape = RugShape::none;
  double x_m = 0.0;
  double y_m = 0.0;
  double half_length_m = 0.0;  // the radius of a round one
  double half_width_m = 0.0;
  double turned_rad = 0.0;
  double roll = 1.0;  // share of the rolling that is left to a wheel that sinks in
  double drag_n_s_m = 0.0;
};

struct FloorSpec {
  double slope_n = 0.0;  // pull downhill on each wheel
  double uphill_rad = 0.0;
  RugSpec rug;
};

inline bool on_rug(const RugSpec& rug, double x_m, double y_m) {
  const double dx_m = x_m - rug.x_m;
  const double dy_m = y_m - rug.y_m;
  if (rug.shape == RugShape::none) return false;
  if (rug.shape == RugShape::round) return dx_m * dx_m + dy_m * dy_m < rug.half_length_m * rug.half_length_m;
  const double cosine = std::cos(rug.turned_rad);
  const double sine = std::sin(rug.turned_rad);
  return std::abs(cosine * dx_m + sine * dy_m) < rug.half_length_m &&
         std::abs(-sine * dx_m + cosine * dy_m) < rug.half_width_m;
}

// Holds a wheel back uphill; the gear holds the robot at rest.
inline double slope_drag_n(const FloorSpec& floor, double heading_rad, double speed_m_s) {
  constexpr double holding_m_s = 0.012;
  if (floor.slope_n == 0.0) return 0.0;
  const double moving = speed_m_s * speed_m_s / (speed_m_s * speed_m_s + holding_m_s * holding_m_s);
  return floor.slope_n * std::cos(heading_rad - floor.uphill_rad) * moving;
}

}  // namespace plants::third
