#pragma once

#include <algorithm>
#include <cmath>

namespace plants::second {

// What touches the floor besides the driven wheels.
struct UndercarriageSpec {
  double felt_drag_n_s_rad = 0.0;  // bristles bent sideways by a turn dig in and hold the robot back
  double skid_moment_n_m = 0.0;    // ploughing skid: scale of its yaw moment
  double skid_rate_rad_s = 1.0;    // turn rate above which the skid ploughs
  double side_brush_n_m = 0.0;     // yaw moment of the side brush, which runs while driving
  double caster_moment_n_m = 0.0;  // plough moment of a caster that stands across
  double caster_trail_m = 0.03;
  double caster_tilt = 0.05;  // leaning pivot: the caster swings round by the left
};

inline double felt_force_n(const UndercarriageSpec& spec, double forward_m_s, double turn_rad_s) {
  constexpr double kSlack_rad_s = 0.05;
  constexpr double kCreep_m_s = 0.02;
  const double bend_rad_s = std::hypot(turn_rad_s, kSlack_rad_s) - kSlack_rad_s;
  return -spec.felt_drag_n_s_rad * bend_rad_s * forward_m_s / std::hypot(forward_m_s, kCreep_m_s);
}

// The skid rides over the pile when turning slowly and digs in when turning fast.
inline double skid_moment_n_m(const UndercarriageSpec& spec, double turn_rad_s) {
  const double relative = turn_rad_s / spec.skid_rate_rad_s;
  return -spec.skid_moment_n_m * relative * (std::sqrt(1.0 + relative * relative) - 1.0);
}

// Trailing caster that has to swing by half a turn after every change of the direction of travel.
class Caster {
 public:
  explicit Caster(const UndercarriageSpec& spec) : spec_(spec) {}

  double moment_n_m(double forward_m_s, double step_s) {
    if (spec_.caster_moment_n_m == 0.0) return 0.0;
    const double swing_rad_s = (-forward_m_s * std::sin(angle_rad_) +
                                spec_.caster_tilt * std::abs(forward_m_s) * std::cos(angle_rad_)) /
                               spec_.caster_trail_m;
    angle_rad_ += step_s * swing_rad_s;
    // Drag of a wheel at slip angle a goes with sin^2 a, its arm about the centre line with sin a.
    const double across = std::sin(angle_rad_);
    return spec_.caster_moment_n_m * across * across * across * std::tanh(forward_m_s / 0.01);
  }

 private:
  UndercarriageSpec spec_;
  double angle_rad_ = 0.0;  // heading of the caster wheel in the body, 0 = trailing in forward travel
};

}  // namespace plants::second
