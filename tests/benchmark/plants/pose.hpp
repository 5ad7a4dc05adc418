#pragma once

#include <cmath>
#include <numbers>

namespace plants {

struct Pose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
};

inline double wrapped_rad(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

// A point that is fixed to the body, `x_m` ahead of the middle of the axle and `y_m` to its left.
inline Pose point_of_body(const Pose& axle, double x_m, double y_m) {
  const double cosine = std::cos(axle.heading_rad);
  const double sine = std::sin(axle.heading_rad);
  return {axle.x_m + cosine * x_m - sine * y_m, axle.y_m + sine * x_m + cosine * y_m, axle.heading_rad};
}

}  // namespace plants
