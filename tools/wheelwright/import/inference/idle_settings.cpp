#include "tools/wheelwright/import/inference/idle_settings.hpp"

#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

bool is_of_wheel(const std::string& unit) {
  const auto found = find_unit(speed_units(), unit);
  return found && found->of_wheel;
}

}  // namespace

void doubt_idle_settings(const GivenMapping& given, const Mapping& mapping,
                         std::vector<std::string>& doubts) {
  if (!given.says("wheels.wheel_radius_m") || !mapping.wheels) return;
  const WheelMapping& wheels = *mapping.wheels;
  if (mapping.command && is_of_wheel(mapping.command->unit)) return;
  if (wheels.kind == WheelKind::counts && !wheels.counts_per_turn) {
    doubts.emplace_back(
        "wheels.wheel_radius_m changes nothing: how many counts a turn of the wheel has is not given (--set "
        "wheels.counts_per_turn)");
  } else if (wheels.kind == WheelKind::distance ||
             (wheels.kind == WheelKind::speed && !is_of_wheel(wheels.unit))) {
    const std::string right = wheels.kind == WheelKind::speed ? "turn/s" : "turn --set wheels.kind=angle";
    doubts.push_back("wheels.wheel_radius_m changes nothing, as the wheels are in " + wheels.unit +
                     "; if they are in turns, rad or deg, say it: --set wheels.unit=" + right);
  }
}

}  // namespace wheelwright::import
