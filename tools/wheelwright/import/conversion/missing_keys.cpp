#include "tools/wheelwright/import/conversion/missing_keys.hpp"

#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {

bool is_one_wheel(const Mapping& mapping) {
  return mapping.wheels && !mapping.wheels->right && !mapping.wheels->body_motion && !mapping.reference;
}

std::string what_is_missing(const Mapping& mapping) {
  if (!mapping.command)
    return "no commands were found; say which columns hold them: --set command.left=COLUMN and "
           "command.right=COLUMN";
  if (!mapping.wheels && !mapping.reference)
    return "neither wheels nor a reference were found; say which columns hold them: --set wheels.left=COLUMN "
           "and wheels.right=COLUMN";
  if (!mapping.wheel_base_m && !is_one_wheel(mapping))
    return "the distance between the wheels is not known; give it: --set robot.wheel_base_m=0.235";
  if (mapping.wheels && mapping.wheels->kind == WheelKind::speed && mapping.wheels->unit.empty()) {
    return "the unit of the wheel speeds is not known; give it: --set wheels.unit=mm/s";
  }
  if (mapping.wheels && !wheel_scale(*mapping.wheels)) {
    return mapping.wheels->kind == WheelKind::counts
               ? "how far a wheel rolls for a count is not known; give it: --set "
                 "wheels.metres_per_count=0.0005"
               : "the radius of the wheels is not known; give it: --set wheels.wheel_radius_m=0.035";
  }
  if (mapping.command->is_duty() && !mapping.command->full_scale_m_s) {
    return "the speed that the largest duty leads to is not known; give it: --set command.full_scale_m_s=0.5";
  }
  return {};
}

}  // namespace wheelwright::import
