// What a physics engine wants of a wheel: torques, of which a model of speeds knows nothing but their ratios.
//
// A drive that follows its command with a lag is a motor whose torque is damping (command - speed); friction
// that costs a speed is damping times that speed. How large the damping is, hangs on what it has to speed up.
#pragma once

#include <optional>
#include <string>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

struct WheelGeometry {
  double radius_m = 0.0;
  // What one wheel's motor speeds up, at the wheel: its own inertia, and the radius squared times half of the
  // robot's mass. Without it there are no torques.
  std::optional<double> inertia_kg_m2;
};

struct WheelTorque {
  double damping_n_m_s = 0.0;  // N m per rad/s
  Figure friction_n_m;
  std::string friction_remark;
};

// Nothing without an inertia, or where the linear part answers at once.
std::optional<WheelTorque> wheel_torque(const WheelLimits& limits, double lag_s, const WheelGeometry& wheel);

}  // namespace wheelwright::tools
