// The travel of the wheels as their channels hold it: counters unwrapped, blanks of a log on change filled.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Distance of one count, or what one unit of the wheel channels is in metres (m/s for speeds), by what the
// mapping says; nothing where it says too little.
std::optional<double> wheel_scale(const WheelMapping& wheels);

// Wheel channels of rows in the order of time: blanks of a log on change filled, a counter unwrapped.
struct WheelTravel {
  std::array<Column, 2> values;
  std::vector<std::string> remarks;
};
WheelTravel wheel_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                         const WheelMapping& wheels);

}  // namespace wheelwright::import
