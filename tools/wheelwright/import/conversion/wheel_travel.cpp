#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

void accumulate(Column& values) {
  double sum = 0.0;
  for (double& value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    value = sum;
  }
}

// An angle that goes round starts again at every turn.
void unwrap_wheel(Column& angles, const std::string& which, const WheelMapping& wheels,
                  const std::string& place, std::vector<std::string>& remarks) {
  const double turn = 2.0 * std::numbers::pi / in_si(angle_units(), wheels.unit);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  for (const double angle : angles) {
    if (!std::isfinite(angle)) continue;
    lowest = std::min(lowest, angle);
    highest = std::max(highest, angle);
  }
  if (!(highest - lowest > 0.6 * turn) || highest - lowest > 1.01 * turn) return;
  std::size_t wraps = 0;
  double last = std::numeric_limits<double>::quiet_NaN();
  double offset = 0.0;
  for (double& angle : angles) {
    if (!std::isfinite(angle)) continue;
    const double jump = std::isfinite(last) ? std::round((angle - last) / turn) : 0.0;
    if (jump != 0.0) ++wraps;
    last = angle;
    offset -= jump * turn;
    angle += offset;
  }
  if (wraps > 0)
    remarks.push_back(place + ": the angle of the " + which + " wheel starts again " + std::to_string(wraps) +
                      " times, unwrapped");
}

}  // namespace

std::optional<double> wheel_scale(const WheelMapping& wheels) {
  switch (wheels.kind) {
    case WheelKind::counts:
      if (wheels.metres_per_count) return wheels.metres_per_count;
      if (!wheels.counts_per_turn || !wheels.wheel_radius_m) return std::nullopt;
      return 2.0 * std::numbers::pi * *wheels.wheel_radius_m / *wheels.counts_per_turn;
    case WheelKind::angle:
      if (!wheels.wheel_radius_m) return std::nullopt;
      return in_si(angle_units(), wheels.unit) * *wheels.wheel_radius_m;
    case WheelKind::distance:
      return in_si(distance_units(), wheels.unit);
    case WheelKind::speed:
      break;
  }
  const auto unit = find_unit(speed_units(), wheels.unit);
  if (!unit) return std::nullopt;
  if (!unit->of_wheel) return unit->in_si;
  if (!wheels.wheel_radius_m) return std::nullopt;
  return unit->in_si * *wheels.wheel_radius_m;
}

WheelTravel wheel_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                         const WheelMapping& wheels) {
  WheelTravel travel;
  for (std::size_t side = 0; side < 2; ++side) {
    const Column& column = columns.wheel[side];
    if (column.empty()) continue;
    Column& values = travel.values[side];
    for (const std::size_t row : rows) values.push_back(column[row]);
    const std::string which = side == 0 ? "left" : "right";
    if (wheels.per_row) accumulate(values);
    if (wheels.kind == WheelKind::angle)
      unwrap_wheel(values, which, wheels, columns.place(rows.front()), travel.remarks);
    if (wheels.kind != WheelKind::counts) continue;
    if (is_log_on_change(values)) {
      fill_down(values);
      if (side == 0)
        travel.remarks.push_back(
            columns.place(rows.front()) +
            ": counts stand only where they changed; a blank is taken for the count above it");
    }
    const auto bits = wheels.bits ? wheels.bits : wrapped_bits(values);
    const std::size_t wraps = bits ? unwrap(values, *bits) : 0;
    if (wraps > 0) {
      travel.remarks.push_back(columns.place(rows.front()) + ": the " + which + " counter of " +
                               std::to_string(*bits) + " bits wraps " + std::to_string(wraps) +
                               " times, unwrapped");
    }
  }
  return travel;
}

}  // namespace wheelwright::import
