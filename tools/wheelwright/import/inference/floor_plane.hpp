// Which of the three coordinates of a tracker lie in the floor: of many, y points up.
#pragma once

#include <cstdint>
#include <vector>

namespace wheelwright::import {

enum class FloorPlane : std::uint8_t {
  x_y,      // z points up
  z_x,      // y points up or down: z and x, in this order, turn about y as x and y do about z
  unclear,  // z changes more than y, but not as much as a robot goes
};

// By how far the places go along each axis, without the outermost hundredth at either end. The robot goes in
// z and x if that is less than a tenth as far along y as along z, and along z at least a quarter as far as
// along x: no floor is so steep.
FloorPlane floor_plane(const std::vector<double>& x, const std::vector<double>& y,
                       const std::vector<double>& z);

// Whether an angle beyond a quarter turn stands beside headings that never are: Euler angles of which the
// heading is the middle one turn a robot on its back and back again. `turn` is a turn in their unit.
bool folds_heading(const std::vector<double>& roll, const std::vector<double>& heading, double turn);

}  // namespace wheelwright::import
