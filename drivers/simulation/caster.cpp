#include "drivers/simulation/caster.hpp"

#include <cmath>

namespace wheelwright::simulation {
namespace {

// Sign with a ramp around zero, so that forces do not chatter at rest.
double soft_sign(double value, double ramp) {
  return value / (std::abs(value) + ramp);
}

}  // namespace

Caster::Force Caster::follow(double forward_m_s, double turn_rad_s, double duration_s) {
  if (is_absent()) return {};
  const double sideways_m_s = turn_rad_s * config_.position_m;
  const double c = std::cos(angle_rad_);
  const double s = std::sin(angle_rad_);
  const double rolling_m_s = forward_m_s * c + sideways_m_s * s;
  const double swivel_rad_s = (sideways_m_s * c - forward_m_s * s) / config_.trail_m - turn_rad_s;
  angle_rad_ += swivel_rad_s * duration_s;
  const double drag_n = config_.rolling_drag_n * soft_sign(rolling_m_s, 0.005);
  // The swivel's friction needs a sideways force at the contact point to overcome it.
  const double swivel_nm = config_.swivel_torque_nm * soft_sign(swivel_rad_s, 0.5);
  const double side_n = swivel_nm / config_.trail_m;
  const double forward_n = -drag_n * c + side_n * s;
  const double sideways_n = -drag_n * s - side_n * c;
  return {forward_n, sideways_n * config_.position_m + swivel_nm};
}

}  // namespace wheelwright::simulation
