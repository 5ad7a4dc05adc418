#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

std::optional<WheelTorque> wheel_torque(const WheelLimits& limits, double lag_s, const WheelGeometry& wheel) {
  if (!wheel.inertia_kg_m2 || !(lag_s > 0.0)) return std::nullopt;
  const double damping = *wheel.inertia_kg_m2 / lag_s;
  if (!limits.friction_loss_m_s) return WheelTorque{damping, Figure{}, "the model has no friction"};
  const Figure friction = scaled(*limits.friction_loss_m_s, damping / wheel.radius_m);
  return WheelTorque{
      damping, friction,
      "of a speed loss of " + value_of(*limits.friction_loss_m_s) + " m/s: " + remark_of(friction)};
}

}  // namespace wheelwright::tools
