#include "tools/wheelwright/import/inference/units/register_units.hpp"

#include <cmath>

#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {

std::optional<Unit> unit_of_gain(double gain, const std::optional<WheelMapping>& wheels) {
  for (const Unit& unit : speed_units()) {
    const auto m_s = speed_in_m_s(unit, wheels);
    if (m_s && unit.name != "km/h" && unit.is_found_by_motion() && is_near(gain, *m_s)) return unit;
  }
  return std::nullopt;
}

std::optional<Unit> register_unit(double gain, const std::optional<WheelMapping>& wheels) {
  constexpr double near = 1.1;
  for (const Unit& unit : speed_units()) {
    const auto m_s = speed_in_m_s(unit, wheels);
    if (unit.is_raw && m_s && std::abs(std::log(gain / *m_s)) < std::log(near)) return unit;
  }
  return std::nullopt;
}

bool are_registers(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings) {
  const ChannelName& command = mapping.command->first;
  WheelMapping& wheels = *mapping.wheels;
  if (!names_a_register(command.channel) || !names_a_register(wheels.left.channel) ||
      !are_whole(columns.command[0]))
    return false;
  if (!wheels.unit_assumed || given.says("wheels.unit")) return true;
  wheels.unit.clear();
  wheels.unit_assumed = false;
  findings.push_back("'" + command.text() + "' and '" + wheels.left.text() +
                     "' are registers of a servo; of a Dynamixel X: --set command.unit=0.229rpm --set "
                     "wheels.unit=0.229rpm");
  return true;
}

}  // namespace wheelwright::import
