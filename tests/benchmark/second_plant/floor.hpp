#pragma once

#include <cmath>

namespace plants::second {

// The floor of the room: tilt and one round rug.
struct FloorSpec {
  double tilt_rad = 0.0;
  double downhill_rad = 0.0;  // direction of the fall line in the room
  double rug_x_m = 0.0;
  double rug_y_m = 0.0;
  double rug_radius_m = 0.0;
  double rug_drag_n_s_m = 0.0;  // pile resistance per wheel
  double rug_grip = 1.0;        // tyre stiffness on the rug over that on the bare floor
};

inline constexpr double kGravity_m_s2 = 9.81;

inline double gravity_force_n(const FloorSpec& floor, double mass_kg, double heading_rad) {
  return mass_kg * kGravity_m_s2 * std::sin(floor.tilt_rad) * std::cos(heading_rad - floor.downhill_rad);
}

// 0 on the bare floor, 1 on the rug; the tyre's footprint straddles the edge.
inline double share_on_rug(const FloorSpec& floor, double x_m, double y_m) {
  if (floor.rug_radius_m <= 0.0) return 0.0;
  constexpr double kFootprint_m = 0.01;
  const double inside_m = floor.rug_radius_m - std::hypot(x_m - floor.rug_x_m, y_m - floor.rug_y_m);
  return 0.5 * (1.0 + std::tanh(inside_m / kFootprint_m));
}

}  // namespace plants::second
