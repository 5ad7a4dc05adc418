#include "tools/wheelwright/import/inference/units/row_counts.hpp"

#include <cmath>

#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {

bool are_counts_of_a_row(const DriveColumns& columns, double gain, const WheelMapping& wheels) {
  constexpr double near = 1.1;  // wheels reach what they are told; units lie further apart
  const auto metres = count_in_metres(wheels);
  const double step_s = median_step_s(columns.t_s);
  return metres && wheels.kind == WheelKind::speed && !wheels.body_motion && step_s > 0.0 &&
         are_whole(columns.wheel[0]) && std::abs(std::log(gain * *metres / step_s)) < std::log(near);
}

void take_counts_of_a_row(WheelMapping& wheels) {
  wheels.kind = WheelKind::counts;
  wheels.per_row = true;
  wheels.unit.clear();
  wheels.unit_assumed = false;
}

}  // namespace wheelwright::import
