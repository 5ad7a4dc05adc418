#include "tests/benchmark/third_plant/gear.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

double Gear::step_m_s(double motor_m_s, double step_s) {
  motor_m_ += step_s * motor_m_s;
  const double half_m = 0.5 * spec_.play_m;
  const double before_m = wheel_m_;
  switch (spec_.play) {
    case Play::sprung:
      step_sprung(motor_m_s, step_s);
      return sprung_m_s_;
    case Play::operator_of_play:
      wheel_m_ = std::clamp(wheel_m_, motor_m_ - half_m, motor_m_ + half_m);
      return (wheel_m_ - before_m) / step_s;
    case Play::none:
      break;
  }
  const double wheel_m_s = motor_m_s * (1.0 + spec_.eccentricity * std::cos(wheel_angle_rad()));
  wheel_m_ += step_s * wheel_m_s;
  return wheel_m_s;
}

void Gear::step_sprung(double motor_m_s, double step_s) {
  constexpr double stiffness_n_m = 4.0e3;
  constexpr double damping_n_s_m = 20.0;
  constexpr double wheel_share = 0.06;
  constexpr double coasting_s = 0.006;
  const double wheel_kg = wheel_share * spec_.rim_mass_kg;
  const double half_m = 0.5 * spec_.play_m;
  const double twist_m = motor_m_ - wheel_m_;
  const double damping_n = damping_n_s_m * (motor_m_s - sprung_m_s_);
  // Teeth push but never pull.
  double tooth_n = 0.0;
  if (twist_m > half_m) tooth_n = std::max(0.0, stiffness_n_m * (twist_m - half_m) + damping_n);
  if (twist_m < -half_m) tooth_n = std::min(0.0, stiffness_n_m * (twist_m + half_m) + damping_n);
  sprung_m_s_ += step_s * (tooth_n / wheel_kg - sprung_m_s_ / coasting_s);
  wheel_m_ += step_s * sprung_m_s_;
}

}  // namespace plants::third
