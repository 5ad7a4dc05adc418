#include "tools/wheelwright/import/conversion/wheel_command.hpp"

#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

WheelPair wheel_command(const Mapping& mapping, double first, double second) {
  const CommandMapping& command = *mapping.command;
  switch (command.kind) {
    case CommandKind::duty: {
      const double factor = command.full_scale_m_s.value_or(1.0) / command.full_scale;
      return {factor * first, factor * second};
    }
    case CommandKind::twist: {
      const double forward = in_si(speed_units(), command.unit) * first;
      const double turning =
          0.5 * *mapping.wheel_base_m * in_si(angular_units(), command.angular_unit) * second;
      return {forward - turning, forward + turning};
    }
    case CommandKind::wheels:
      break;
  }
  const auto unit = find_unit(speed_units(), command.unit);
  const double radius_m =
      unit && unit->of_wheel ? (mapping.wheels ? mapping.wheels->wheel_radius_m.value_or(1.0) : 1.0) : 1.0;
  const double factor = (unit ? unit->in_si : 1.0) * radius_m;
  return {factor * first, factor * second};
}

}  // namespace wheelwright::import
