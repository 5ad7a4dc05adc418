#include "tools/wheelwright/import/conversion/body_motion.hpp"

#include <cstddef>

#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

std::span<const Unit> turning_units(const WheelMapping& wheels) {
  return wheels.kind == WheelKind::speed ? angular_units() : angle_units();
}

void body_motion_to_wheels(DriveColumns& columns, const Mapping& mapping) {
  if (!mapping.wheels || !mapping.wheels->body_motion || columns.wheel[1].empty()) return;
  const WheelMapping& wheels = *mapping.wheels;
  const auto units = wheels.kind == WheelKind::speed ? speed_units() : distance_units();
  const double half_base = 0.5 * mapping.wheel_base_m.value_or(0.0) *
                           in_si(turning_units(wheels), wheels.angular_unit) / in_si(units, wheels.unit);
  for (std::size_t row = 0; row < columns.wheel[0].size(); ++row) {
    double& left = columns.wheel[0][row];
    double& right = columns.wheel[1][row];
    const double apart = half_base * right;
    right = left + apart;
    left -= apart;
  }
}

}  // namespace wheelwright::import
