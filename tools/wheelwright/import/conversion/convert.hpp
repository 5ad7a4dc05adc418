// Mapped columns to drive logs: units to SI, counts unwrapped, time made to rise, one log per run.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "model/drive_log.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

struct Conversion {
  std::vector<DriveLog> runs;
  std::vector<std::string> remarks;  // what was done to the data, one line each, with the places
};

// Fails, with one line, where a run cannot be made of them: no commands, no wheel base, no scale of the
// counts.
tl::expected<Conversion, std::string> convert(const DriveColumns& columns, const Mapping& mapping,
                                              const std::string& name);

// The runs of the rows: time made to rise (time_repair.hpp) within each run that the files tell apart.
TimeRepair repair_runs(const DriveColumns& columns);

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
