// Friction of one bearing and gear: Coulomb, stiction with a Stribeck curve, and viscous.
//
// At rest the surfaces hold each other by bristles that bend; a torque below stiction only bends them (C.
// Canudas de Wit et al., "A new model for control of systems with friction", 1995). The bristles are
// integrated implicitly, so that the model is stable at any speed and step.
#pragma once

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class BearingFriction {
 public:
  // `inertia_kg_m2` is what the friction acts on: the bristles are damped for it.
  BearingFriction(const FrictionConfig& config, double inertia_kg_m2);

  // Moves the bristles on, and returns the torque against motion. `scale` multiplies all friction (1: as
  // configured).
  double torque_nm(double speed_rad_s, double scale, double duration_s);

 private:
  FrictionConfig config_;
  double stiffness_nm_per_rad_ = 0.0;
  double damping_nm_s_per_rad_ = 0.0;
  double deflection_rad_ = 0.0;
};

}  // namespace wheelwright::simulation
