// The front caster: it trails behind its swivel, drags a little, and turns over when travel is reversed.
//
// Its wheel does not slide sideways, which decides how fast it swivels; the swivel's friction and the wheel's
// drag push on the body while it does.
#pragma once

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class Caster {
 public:
  explicit Caster(const CasterConfig& config) : config_(config) {}

  struct Force {
    double forward_n = 0.0;  // on the body, along its x
    double yaw_nm = 0.0;     // about the middle of the axle
  };
  // Lets the caster follow the body's motion for a while, and returns what it does to the body.
  Force follow(double forward_m_s, double turn_rad_s, double duration_s);

  bool is_absent() const { return config_.rolling_drag_n == 0.0 && config_.swivel_torque_nm == 0.0; }

 private:
  CasterConfig config_;
  double angle_rad_ = 0.02;  // its rolling direction against the body's x; never exactly straight
};

}  // namespace wheelwright::simulation
