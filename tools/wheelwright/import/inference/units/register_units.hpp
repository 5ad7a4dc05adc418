// The unit of a speed by what one of it is in m/s at the wheel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

// Among the units that motion can show (Unit::is_found_by_motion).
std::optional<Unit> unit_of_gain(double gain, const std::optional<WheelMapping>& wheels);

// Among those of the registers of a servo, within a tenth, because other units are near them.
std::optional<Unit> register_unit(double gain, const std::optional<WheelMapping>& wheels);

// Whether commands and wheel speeds are both such registers. Their unit is that of the servo, which nothing
// in the log shows: unless it is given it becomes unknown, with a line in `findings`.
bool are_registers(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings);

}  // namespace wheelwright::import
