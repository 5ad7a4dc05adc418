#include "tests/benchmark/fourth_plant/wheel_drive.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fourth {

double Friction::level_m_s(double speed_m_s) const {
  const double ratio = speed_m_s / stribeck_m_s;
  return moving_m_s + std::max(0.0, breakaway_m_s - moving_m_s) * std::exp(-ratio * ratio);
}

WheelDrive::WheelDrive(const DriveSpec& spec, double step_s)
    : spec_(spec),
      step_s_(step_s),
      amplifier_decay_(std::exp(-step_s / spec.amplifier_lag_s)),
      mechanical_decay_(std::exp(-step_s / spec.mechanical_lag_s)),
      coupling_(spec.amplifier_lag_s / (spec.amplifier_lag_s - spec.mechanical_lag_s) *
                (amplifier_decay_ - mechanical_decay_)) {}

double WheelDrive::step(double asked_m_s, Chain& drive, Chain& load, const Moment& moment) {
  const double wanted_m_s = controlled(filtered(asked_m_s));
  double loss_m_s = 0.0;
  for (Block& block : load) loss_m_s += block(speed_m_s_, moment);
  turn_motor(spec_.gain * through(drive, wanted_m_s, moment), loss_m_s);
  return speed_m_s_;
}

double WheelDrive::filtered(double asked_m_s) {
  if (!spec_.filtered) return asked_m_s;
  const double stiffness = spec_.filter_rad_s * spec_.filter_rad_s;
  const double damping = 2.0 * spec_.filter_damping * spec_.filter_rad_s;
  filter_slope_m_s2_ += step_s_ * (stiffness * (asked_m_s - filter_m_s_) - damping * filter_slope_m_s2_);
  filter_m_s_ += step_s_ * filter_slope_m_s2_;
  return filter_m_s_;
}

double WheelDrive::controlled(double asked_m_s) {
  double wanted_m_s = asked_m_s;
  const double error_m_s = asked_m_s - speed_m_s_;
  if (spec_.in_loop) wanted_m_s += spec_.proportional * error_m_s + integral_m_s_;
  const double limited_m_s = std::clamp(wanted_m_s, -spec_.drive_limit_m_s, spec_.drive_limit_m_s);
  if (spec_.integral_per_s > 0.0) {
    integral_m_s_ +=
        step_s_ * (spec_.integral_per_s * error_m_s + spec_.unwinding_per_s * (limited_m_s - wanted_m_s));
  }
  return limited_m_s;
}

// The exact solution over one step in which drive and loss stand still. Friction takes what would be left of
// the speed at the end of the step, if it can: that is how a wheel comes to rest and stays there.
void WheelDrive::turn_motor(double drive_m_s, double loss_m_s) {
  const double deviation_m_s = amplifier_m_s_ - drive_m_s;
  const double response = 1.0 - mechanical_decay_;
  const double free_m_s =
      mechanical_decay_ * speed_m_s_ + response * (drive_m_s - loss_m_s) + coupling_ * deviation_m_s;
  const double level_m_s = spec_.friction.level_m_s(speed_m_s_);
  const double rubbed_m_s = std::clamp(free_m_s / response, -level_m_s, level_m_s);
  speed_m_s_ = free_m_s - response * rubbed_m_s;
  amplifier_m_s_ = drive_m_s + amplifier_decay_ * deviation_m_s;
}

}  // namespace plants::fourth
