// The travel of the wheels as their channels hold it: counters unwrapped, blanks of a log on change filled.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

// Distance of one count, or what one unit of the wheel channels is in metres (m/s for speeds), by what the
// mapping says; nothing where it says too little.
std::optional<double> wheel_scale(const WheelMapping& wheels);

// How far a wheel rolls for a count; nothing where the mapping does not say it.
std::optional<double> count_in_metres(const WheelMapping& wheels);

// A unit of speed in m/s at the wheel; nothing where it takes the radius of the wheels or the distance of a
// count, and those are not known.
std::optional<double> speed_in_m_s(const Unit& unit, const std::optional<WheelMapping>& wheels);

// What is commanded to a wheel over the time since the row before, from its command at each of the rows.
Column commanded_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                        const Column& command);

// Wheel channels of rows in the order of time: blanks of a log on change filled, a counter unwrapped, and a
// direction given to counts that have none where the mapping says so.
struct WheelTravel {
  std::array<Column, 2> values;
  std::vector<std::string> remarks;
};
WheelTravel wheel_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                         const Mapping& mapping);

}  // namespace wheelwright::import
