#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/fast_counter.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_direction.hpp"
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
  const double size = range_of(angles).size();
  if (!(size > 0.6 * turn) || size > 1.01 * turn) return;
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

std::optional<double> count_in_metres(const WheelMapping& wheels) {
  if (wheels.metres_per_count) return wheels.metres_per_count;
  if (!wheels.counts_per_turn || !wheels.wheel_radius_m) return std::nullopt;
  return 2.0 * std::numbers::pi * *wheels.wheel_radius_m / *wheels.counts_per_turn;
}

std::optional<double> speed_in_m_s(const Unit& unit, const std::optional<WheelMapping>& wheels) {
  if (!unit.of_wheel && !unit.of_count) return unit.in_si;
  if (!wheels) return std::nullopt;
  if (unit.of_count) return count_in_metres(*wheels);
  if (!wheels->wheel_radius_m) return std::nullopt;
  return unit.in_si * *wheels->wheel_radius_m;
}

std::optional<double> wheel_scale(const WheelMapping& wheels) {
  switch (wheels.kind) {
    case WheelKind::counts:
      return count_in_metres(wheels);
    case WheelKind::angle:
      if (!wheels.wheel_radius_m) return std::nullopt;
      return in_si(angle_units(), wheels.unit) * *wheels.wheel_radius_m;
    case WheelKind::distance:
      return in_si(distance_units(), wheels.unit);
    case WheelKind::speed:
      break;
  }
  const auto unit = find_unit(speed_units(), wheels.unit);
  return unit ? speed_in_m_s(*unit, wheels) : std::nullopt;
}

Column commanded_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                        const Column& command) {
  Column travel(rows.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 1; i < rows.size(); ++i)
    travel[i] = command[i - 1] * (columns.t_s[rows[i]] - columns.t_s[rows[i - 1]]);
  return travel;
}

namespace {

class TravelReader {
 public:
  TravelReader(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping)
      : columns_(columns), rows_(rows), mapping_(mapping), wheels_(*mapping.wheels) {}

  WheelTravel read() {
    for (std::size_t side = 0; side < 2; ++side) {
      if (!columns_.wheel[side].empty()) read_side(side);
    }
    return std::move(travel_);
  }

 private:
  void say(const std::string& what) {
    travel_.remarks.push_back(columns_.place(rows_.front()) + ": " + what);
  }

  void read_side(std::size_t side) {
    Column& values = travel_.values[side];
    values.reserve(rows_.size());
    for (const std::size_t row : rows_) values.push_back(columns_.wheel[side][row]);
    const std::string which = side == 0 ? "left" : "right";
    if (wheels_.per_row) accumulate(values);
    if (wheels_.kind == WheelKind::angle)
      unwrap_wheel(values, which, wheels_, columns_.place(rows_.front()), travel_.remarks);
    if (wheels_.kind == WheelKind::counts) unwrap_counts(values, side, which);
    if (!wheels_.by_command_sign || mapping_.command == std::nullopt) return;
    const auto commands = wheel_commands(columns_, rows_, mapping_);
    if (!commands[side].empty()) direct_by_command(values, wheels_.kind == WheelKind::speed, commands[side]);
  }

  void unwrap_counts(Column& values, std::size_t side, const std::string& which) {
    if (!columns_.has_misread_counts && is_log_on_change(values)) {
      fill_down(values);
      if (side == 0)
        say("counts are written only where they changed; a blank is taken for the count above it");
    }
    if (wheels_.bits && wheels_.unwrap_by_command) {
      if (unwrap_fast(values, side)) return;
      say("the " + which +
          " counter may go more than half around between rows, and this run does not show how far; taken the "
          "short way");
    }
    const auto bits = wheels_.bits ? wheels_.bits : wrapped_bits(values);
    const std::size_t wraps = bits ? unwrap(values, *bits) : 0;
    if (wraps > 0) {
      say("the " + which + " counter of " + std::to_string(*bits) + " bits wraps " + std::to_string(wraps) +
          " times, unwrapped");
    }
  }

  bool unwrap_fast(Column& values, std::size_t side) const {
    const auto commands = wheel_commands(columns_, rows_, mapping_);
    if (commands[side].empty()) return false;
    const Column travel = commanded_travel(columns_, rows_, commands[side]);
    const auto prediction = predict_counter(values, travel, *wheels_.bits, std::nullopt);
    if (!prediction.is_sure()) return false;
    unwrap_by_prediction(values, travel, *wheels_.bits, prediction);
    return true;
  }

  const DriveColumns& columns_;
  std::span<const std::size_t> rows_;
  const Mapping& mapping_;
  const WheelMapping& wheels_;
  WheelTravel travel_;
};

}  // namespace

WheelTravel wheel_travel(const DriveColumns& columns, std::span<const std::size_t> rows,
                         const Mapping& mapping) {
  return TravelReader(columns, rows, mapping).read();
}

}  // namespace wheelwright::import
