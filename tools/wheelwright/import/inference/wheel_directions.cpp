#include "tools/wheelwright/import/inference/wheel_directions.hpp"

#include <cmath>
#include <cstddef>

namespace wheelwright::import {

std::array<double, 2> wheel_directions(const Mapping& mapping, const std::array<ResponseFit, 2>& fits) {
  const WheelMapping& wheels = *mapping.wheels;
  std::array<double, 2> result{wheels.left_reversed ? -1.0 : 1.0, wheels.right_reversed ? -1.0 : 1.0};
  if (!mapping.command || mapping.command->is_of_body()) return result;
  for (std::size_t k = 0; k < 2; ++k) {
    if (fits[k].explained >= unit_explained) result[k] = std::copysign(1.0, fits[k].gain);
  }
  return result;
}

}  // namespace wheelwright::import
