#include "tools/wheelwright/import/conversion/missing_keys.hpp"

#include <algorithm>
#include <string_view>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

void add_wheel_keys(const WheelMapping& wheels, std::vector<MissingKey>& missing) {
  if (wheels.kind == WheelKind::speed && wheels.unit.empty()) {
    missing.push_back({"the unit of the wheel speeds", names_a_register(wheels.left.channel)
                                                           ? "command.unit=0.229rpm wheels.unit=0.229rpm"
                                                           : "wheels.unit=mm/s"});
    return;
  }
  if (wheel_scale(wheels)) return;
  const auto unit = find_unit(speed_units(), wheels.unit);
  const bool is_count =
      wheels.kind == WheelKind::counts || (wheels.kind == WheelKind::speed && unit && unit->of_count);
  missing.push_back(is_count
                        ? MissingKey{"how far a wheel rolls for a count", "wheels.metres_per_count=0.0005"}
                        : MissingKey{"the radius of the wheels", "wheels.wheel_radius_m=0.035"});
}

}  // namespace

bool is_one_wheel(const Mapping& mapping) {
  return mapping.wheels && !mapping.wheels->right && !mapping.wheels->body_motion && !mapping.reference;
}

std::vector<MissingKey> missing_keys(const Mapping& mapping) {
  std::vector<MissingKey> missing;
  const bool one_wheel = is_one_wheel(mapping);
  if (!mapping.command) {
    missing.push_back(
        {"commands", one_wheel ? "command.left=COLUMN" : "command.left=COLUMN command.right=COLUMN", true});
  }
  if (!mapping.wheels && !mapping.reference)
    missing.push_back({"wheels", "wheels.left=COLUMN wheels.right=COLUMN", true});
  if (!mapping.wheel_base_m && !one_wheel)
    missing.push_back({"the distance between the wheels", "robot.wheel_base_m=0.235"});
  if (mapping.wheels) add_wheel_keys(*mapping.wheels, missing);
  if (mapping.reference && mapping.reference->unit == pixel_unit && !mapping.reference->metres_per_pixel)
    missing.push_back({"how far a pixel is on the floor", "reference.metres_per_pixel=0.003"});
  if (mapping.command && mapping.command->is_duty() && !mapping.command->full_scale_m_s)
    missing.push_back({"the speed that the largest duty leads to", "command.full_scale_m_s=0.5"});
  return missing;
}

std::string what_is_missing(const Mapping& mapping) {
  std::string not_found;
  std::string not_known;
  std::string example;
  std::size_t unknown = 0;
  for (const MissingKey& key : missing_keys(mapping)) {
    if (key.is_column) {
      not_found += (not_found.empty() ? "no " : " and no ") + key.what;
    } else {
      not_known += (unknown++ == 0 ? "" : ", and ") + key.what;
    }
    std::string settings = " " + key.example;
    constexpr std::string_view set = " --set ";
    for (std::size_t at = 0; (at = settings.find(' ', at)) != std::string::npos; at += set.size())
      settings.replace(at, 1, set);
    example += settings;
  }
  std::string what = not_found.empty() ? "" : not_found + " were found";
  if (!not_known.empty())
    what += (what.empty() ? "" : "; ") + not_known + (unknown > 1 ? " are" : " is") + " not known";
  if (what.empty()) return what;
  // Where commands in m/s do not explain how far the wheels go, their unit says how far a count or a turn is.
  const bool may_be_by_command =
      mapping.command && !mapping.command->is_duty() && mapping.command->unit == "m/s" && mapping.wheels &&
      (mapping.wheels->kind == WheelKind::counts || mapping.wheels->kind == WheelKind::angle) &&
      !wheel_scale(*mapping.wheels);
  const bool two_sides = !mapping.command && !is_one_wheel(mapping);
  const bool may_be_speeds = mapping.command && mapping.command->second &&
                             mapping.command->kind == CommandKind::duty &&
                             std::ranges::all_of(mapping.command->first.channel, config::is_digit) &&
                             !mapping.command->full_scale_m_s;
  return what + "; give" + example +
         (two_sides ? " (forward and turning speed are command.linear and command.angular)" : "") +
         (may_be_speeds ? " (of commands that are no duty but mm/s, --set command.unit=mm/s)" : "") +
         (may_be_by_command ? " (or what the commands are in, if not m/s: --set command.unit=mm/s)" : "");
}

}  // namespace wheelwright::import
