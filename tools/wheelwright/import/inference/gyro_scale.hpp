// The unit of a gyro, by how far the robot turns by its wheels.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets the unit where the file says none, and says so; a doubt where the wheels do not show it, or
// show another than is stated.
void set_gyro_unit(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
