// What stands between a motor and its wheel.
#pragma once

#include <algorithm>
#include <cmath>

namespace wheelwright::test {

// LuGre friction (Canudas de Wit, Olsson, Astrom, Lischinsky 1995): bristles that bend before they slide,
// with a Stribeck fall from breakaway to sliding. Forces here are in m/s: the speed that they cost a wheel.
class LuGreFriction {
 public:
  LuGreFriction(double sliding, double breakaway) : sliding_(sliding), breakaway_(breakaway) {}

  double step(double speed_m_s, double dt_s) {
    if (breakaway_ <= 0.0) return 0.0;
    const double level = sliding_ + (breakaway_ - sliding_) *
                                        std::exp(-(speed_m_s / stribeck_m_s) * (speed_m_s / stribeck_m_s));
    const double stiffness = breakaway_ / presliding_m;
    // z' = v - stiffness |v| / level z, exact over a step of constant speed.
    const double decay = std::exp(-stiffness * std::abs(speed_m_s) / level * dt_s);
    const double end_m = std::copysign(level / stiffness, speed_m_s);
    const double before_m = bend_m_;
    bend_m_ = std::abs(speed_m_s) > 1e-12 ? end_m + (bend_m_ - end_m) * decay : bend_m_;
    // The bristles damp what little they move, near critically, and no longer once they slide.
    const double damping = std::sqrt(stiffness * inertia_s) * std::exp(-std::pow(speed_m_s / damped_m_s, 2));
    return stiffness * bend_m_ + damping * (bend_m_ - before_m) / dt_s;
  }

 private:
  static constexpr double stribeck_m_s = 0.01;
  static constexpr double damped_m_s = 0.005;
  static constexpr double presliding_m = 2e-5;
  static constexpr double inertia_s = 0.075;  // of a wheel: its time constant under a force in m/s
  double sliding_;
  double breakaway_;
  double bend_m_ = 0.0;
};

// The play operator (Krasnoselskii and Pokrovskii): the wheel is dragged along by either side of the gap.
class Play {
 public:
  explicit Play(double gap_m) : half_m_(0.5 * gap_m) {}
  double step(double motor_m) {
    return wheel_m_ = std::clamp(wheel_m_, motor_m - half_m_, motor_m + half_m_);
  }

 private:
  double half_m_;
  double wheel_m_ = 0.0;
};

// Travel behind a gear whose axle is off its centre by `eccentricity` of the radius.
inline double eccentric_travel_m(double motor_m, double radius_m, double eccentricity, double phase_rad) {
  const double angle = motor_m / radius_m + phase_rad;
  return motor_m +
         radius_m * std::atan2(eccentricity * std::sin(angle), 1.0 - eccentricity * std::cos(angle));
}

// A spring with Bouc-Wen hysteresis in series with a mass: a resonance whose losses depend on amplitude.
class HystereticSpring {
 public:
  double step(double force, double dt_s) {
    constexpr double omega = 22.0;
    constexpr double yield = 0.04;
    slip_ += dt_s * rate_ * (1.0 - 0.5 * (1.0 + std::copysign(1.0, rate_ * slip_)) * std::abs(slip_) / yield);
    rate_ += dt_s * (omega * omega * (force - 0.6 * force_ - 0.4 * slip_) - 0.35 * omega * rate_);
    force_ += dt_s * rate_;
    return force_;
  }

 private:
  double force_ = 0.0;
  double rate_ = 0.0;
  double slip_ = 0.0;
};

}  // namespace wheelwright::test
