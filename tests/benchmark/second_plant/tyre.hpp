#pragma once

#include <cmath>

namespace plants::second {

// Tyre on the floor: force over slip speed after Pacejka's formula, linear for small slip.
struct TyreSpec {
  double wheel_mass_kg = 0.25;  // wheel inertia as a mass at the rim
  double hub_drag_n_s_m = 0.0;
  double quadratic_drag_n_s2_m2 = 0.0;  // a fan or brush geared to the wheel
  double stiffness_n_s_m = 300.0;
  double peak_n = 500.0;
  double shape = 1.5;
  double radius_m = 0.036;
  double rolling_factor = 1.0;  // true rolling radius over the calibrated one
  double hub_offset_m = 0.0;    // wheel bored off centre
  double high_point_rad = 0.0;  // encoder angle at which the eccentric part stands highest
};

inline double tyre_force_n(const TyreSpec& spec, double slip_m_s, double grip) {
  const double slope = grip * spec.stiffness_n_s_m / (spec.peak_n * spec.shape);
  return spec.peak_n * std::sin(spec.shape * std::atan(slope * slip_m_s));
}

inline double hub_drag_n(const TyreSpec& spec, double wheel_m_s) {
  return spec.hub_drag_n_s_m * wheel_m_s + spec.quadratic_drag_n_s2_m2 * wheel_m_s * std::abs(wheel_m_s);
}

// Metres of floor per metre of nominal rim travel at this wheel angle.
inline double rolling_ratio(const TyreSpec& spec, double wheel_angle_rad) {
  return spec.rolling_factor *
         (1.0 + spec.hub_offset_m / spec.radius_m * std::cos(wheel_angle_rad - spec.high_point_rad));
}

}  // namespace plants::second
