#pragma once

#include <cmath>

namespace plants::third {

struct TyreSpec {
  double rolling_factor = 1.0;  // metres of floor per metre that the encoder knows of
  double eccentricity = 0.0;    // wheel off its centre, relative to its radius
  double grip_m_s2 = 0.0;       // peak of the tyre force as an acceleration; 0 = it never slides
};

// Tyre between the wheel and the floor.
class Tyre {
 public:
  explicit Tyre(const TyreSpec& spec) : spec_(spec) {}

  // Returns the speed over the floor. `roll` is what the floor leaves of the rolling.
  double step_m_s(double wheel_m_s, double wheel_angle_rad, double roll, double step_s) {
    const double rolling_m_s =
        wheel_m_s * spec_.rolling_factor * roll * (1.0 + spec_.eccentricity * std::cos(wheel_angle_rad));
    if (spec_.grip_m_s2 == 0.0) return rolling_m_s;
    floor_m_s_ += step_s * pull_m_s2(rolling_m_s - floor_m_s_);
    return floor_m_s_;
  }

 private:
  // After Pacejka's formula.
  [[nodiscard]] double pull_m_s2(double slip_m_s) const {
    constexpr double shape = 1.35;
    constexpr double stiffness_1_s = 220.0;
    return spec_.grip_m_s2 * std::sin(shape * std::atan(stiffness_1_s * slip_m_s / spec_.grip_m_s2));
  }

  TyreSpec spec_;
  double floor_m_s_ = 0.0;
};

}  // namespace plants::third
