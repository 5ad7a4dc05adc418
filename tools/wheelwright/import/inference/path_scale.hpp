// How far a wheel goes for a count, by where the robot was.
#pragma once

#include <array>
#include <optional>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

struct PathScale {
  double metres_per_unit = 0.0;  // of wheel travel: a count, a radian
  double angle_in_rad =
      1.0;  // of the headings as they stand in the columns: radians or degrees, whichever fits
};

// The slope of the places of a reference over the path that the travel makes along its headings, each about
// its mean. `directions`: 1, or -1 of a wheel that counts backwards. Nothing without places and headings, of
// speeds, or if the path is not that of the places.
std::optional<PathScale> path_scale(const DriveColumns& columns, const Mapping& mapping,
                                    const std::array<double, 2>& directions);

// Metres per unit of travel by how far the headings turn between the wheels, whose base has to be known:
// whatever the unit of the places.
std::optional<double> turn_scale(const DriveColumns& columns, const Mapping& mapping,
                                 const std::array<double, 2>& directions, double angle_in_rad);

}  // namespace wheelwright::import
