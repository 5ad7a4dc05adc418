#include "tools/wheelwright/import/conversion/wrapped_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

// The turn after which the angles start again; nothing of angles that go on.
std::optional<double> turn_of(const std::vector<double>& angles) {
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  constexpr double turn_deg = 360.0;
  const double size = range_of(angles).size();
  if (size <= 1.01 * turn_rad) return turn_rad;
  const bool jumps = std::ranges::adjacent_find(angles, [](double a, double b) {
                       return std::abs(b - a) > 0.5 * turn_deg;
                     }) != angles.end();
  return jumps && size <= 1.01 * turn_deg ? std::optional(turn_deg) : std::nullopt;
}

}  // namespace

void unwrap_angles(std::vector<double>& angles) {
  const auto turn = turn_of(angles);
  if (!turn) return;
  double last = nothing;
  for (double& angle : angles) {
    if (!std::isfinite(angle)) continue;
    if (std::isfinite(last)) angle -= *turn * std::round((angle - last) / *turn);
    last = angle;
  }
}

}  // namespace wheelwright::import
