// A run, for a person: where the robot went by each source of its pose, how fast, and what happened.
#pragma once

#include <optional>
#include <string>

#include "config/load/csv_table.hpp"
#include "tools/wheelwright/report/run_material.hpp"

namespace wheelwright::tools {

// `truth` is what roomba-sim wrote of its true motion (columns t, x, y, theta, speed_left, speed_right), in
// its own frame and time; the route in it begins where the last long stand ends.
std::string run_section(const RunMaterial& run, const std::optional<config::CsvTable>& truth);

}  // namespace wheelwright::tools
