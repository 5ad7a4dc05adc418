#include "drivers/simulation/bearing_friction.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::simulation {

BearingFriction::BearingFriction(const FrictionConfig& config, double inertia_kg_m2) : config_(config) {
  config_.stiction_nm = std::max(config.stiction_nm, config.coulomb_nm);
  if (config_.stiction_nm <= 0.0) return;
  stiffness_nm_per_rad_ = config_.stiction_nm / config_.bristle_deflection_rad;
  damping_nm_s_per_rad_ = std::sqrt(stiffness_nm_per_rad_ * inertia_kg_m2);
}

double BearingFriction::torque_nm(double speed_rad_s, double scale, double duration_s) {
  const double viscous_nm = config_.viscous_nm_s_per_rad * speed_rad_s;
  if (stiffness_nm_per_rad_ == 0.0) return scale * viscous_nm;
  const double relative = speed_rad_s / config_.stribeck_speed_rad_s;
  const double stribeck = 1.0 / (1.0 + relative * relative);
  const double limit_nm = config_.coulomb_nm + (config_.stiction_nm - config_.coulomb_nm) * stribeck;
  const double release_per_s = stiffness_nm_per_rad_ * std::abs(speed_rad_s) / std::max(limit_nm, 1e-9);
  const double before_rad = deflection_rad_;
  deflection_rad_ = (before_rad + speed_rad_s * duration_s) / (1.0 + release_per_s * duration_s);
  const double bending_rad_s = (deflection_rad_ - before_rad) / duration_s;
  // Damping is there to calm the bristles at rest; in motion it would act as a friction of its own.
  const double damping_nm = damping_nm_s_per_rad_ * stribeck * bending_rad_s;
  return scale * (stiffness_nm_per_rad_ * deflection_rad_ + damping_nm + viscous_nm);
}

}  // namespace wheelwright::simulation
