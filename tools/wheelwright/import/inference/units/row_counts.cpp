#include "tools/wheelwright/import/inference/units/row_counts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/column_shapes.hpp"

namespace wheelwright::import {
namespace {

double usual_step_s(const Column& t_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    const double step = t_s[i] - t_s[i - 1];
    if (std::isfinite(step) && step > 0.0) steps.push_back(step);
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace

bool are_counts_of_a_row(const DriveColumns& columns, double gain, const WheelMapping& wheels) {
  constexpr double near = 1.1;  // wheels reach what they are told; units lie further apart
  const auto metres = count_in_metres(wheels);
  const double step_s = usual_step_s(columns.t_s);
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
