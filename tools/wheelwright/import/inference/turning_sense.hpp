// In which sense a reference turns: its headings against its places, and both against the wheels.
#pragma once

#include <array>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// How headings and places go, in one unit of the headings.
struct TurningSense {
  double with = 0.0;      // 0 to 1: the direction of the motion turns as the heading does
  double against = 0.0;   // or against it
  double headings = 0.0;  // correlation of the turns of the headings with those of the robot
  double places = 0.0;    // correlation of the turns of the motion with those of the robot
};

// Of windows of half a second. The robot turns as its wheels do, each times its direction (1, or -1 of one
// that counts backwards), or, without wheels that count, as it is commanded. Headings are in radians or in
// degrees, whichever the motion and the turns of the robot follow more closely, unless `unit_is_known`.
TurningSense turning_sense(const DriveColumns& columns, const Mapping& mapping,
                           const std::array<double, 2>& directions, bool unit_is_known);

// Whether the turns of the robot are those of its wheels, and not of its commands.
bool has_turning_wheels(const DriveColumns& columns, const Mapping& mapping);

// Correlation of the turns of a gyro with those of the wheels; 0 without either.
double gyro_sense(const DriveColumns& columns, const Mapping& mapping,
                  const std::array<double, 2>& directions);

}  // namespace wheelwright::import
