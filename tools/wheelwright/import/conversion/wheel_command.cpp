#include "tools/wheelwright/import/conversion/wheel_command.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

WheelPair wheel_command(const Mapping& mapping, double first, double second) {
  const CommandMapping& command = *mapping.command;
  switch (command.kind) {
    case CommandKind::throttle: {
      const double factor = command.full_scale_m_s.value_or(1.0) / command.full_scale;
      const double steering = command.steering_gain * second;
      return {factor * (first - steering), factor * (first + steering)};
    }
    case CommandKind::duty: {
      const double factor = command.full_scale_m_s.value_or(1.0) / command.full_scale;
      return {factor * first, factor * second};
    }
    case CommandKind::twist: {
      const double forward = in_si(speed_units(), command.unit) * first;
      const double turning =
          0.5 * *mapping.wheel_base_m * in_si(angular_units(), command.angular_unit) * second;
      return {forward - turning, forward + turning};
    }
    case CommandKind::wheels:
      break;
  }
  const auto unit = find_unit(speed_units(), command.unit);
  const double factor = unit ? speed_in_m_s(*unit, mapping.wheels).value_or(unit->in_si) : 1.0;
  return {factor * first, factor * second};
}

std::array<Column, 2> wheel_commands(const DriveColumns& columns, std::span<const std::size_t> rows,
                                     const Mapping& mapping) {
  const bool is_twist = mapping.command->kind == CommandKind::twist;
  if (columns.command[0].empty() || (is_twist && !mapping.wheel_base_m)) return {};
  std::array<Column, 2> result;
  double first = std::numeric_limits<double>::quiet_NaN();
  double second = columns.command[1].empty() && mapping.command->is_of_body() ? 0.0 : first;
  for (const std::size_t row : rows) {
    if (std::isfinite(columns.command[0][row])) first = columns.command[0][row];
    if (columns.command[1].empty()) {
      if (!mapping.command->is_of_body()) second = first;
    } else if (std::isfinite(columns.command[1][row])) {
      second = columns.command[1][row];
    }
    const WheelPair wheels = wheel_command(mapping, first, second);
    result[0].push_back(wheels.left);
    result[1].push_back(wheels.right);
  }
  return result;
}

void subtract_neutral(DriveColumns& columns, double neutral) {
  if (neutral == 0.0) return;
  for (Column& command : columns.command) {
    const bool zero_is_rest = neutral > 0.0 && std::ranges::none_of(command, [neutral](double value) {
                                return value != 0.0 && value < 0.5 * neutral;
                              });
    for (double& value : command) value = value == 0.0 && zero_is_rest ? 0.0 : value - neutral;
  }
}

void reverse_commands(DriveColumns& columns, const CommandMapping& command) {
  const std::array reversed{command.left_reversed, command.right_reversed};
  for (std::size_t side = 0; side < 2; ++side) {
    if (!reversed[side]) continue;
    for (double& value : columns.command[side]) value = -value;
  }
}

namespace {

double with_sign(double value) {
  constexpr double of_16_bits = 65536.0;
  return value > 0.5 * of_16_bits ? value - of_16_bits : value;
}

// Of whole millimetres.
std::optional<WheelPair> special_arc(double velocity, double radius) {
  constexpr double straight = 32767.0;
  if (std::abs(radius) >= straight || radius == 0.0) return WheelPair{velocity, velocity};
  if (radius == 1.0) return WheelPair{-velocity, velocity};
  if (radius == -1.0) return WheelPair{velocity, -velocity};
  return std::nullopt;
}

WheelPair on_arc(double velocity, double radius, double half_base) {
  const double share = half_base / radius;
  return {velocity * (1.0 - share), velocity * (1.0 + share)};
}

}  // namespace

void turn_by_radius(DriveColumns& columns, const Mapping& mapping) {
  const double unit_m = in_si(speed_units(), mapping.command->unit);
  const bool in_millimetres = mapping.command->unit == "mm/s";
  const double half_base = mapping.wheel_base_m ? 0.5 * *mapping.wheel_base_m / unit_m : 0.0;
  for (std::size_t row = 0; row < columns.command[0].size(); ++row) {
    double& left = columns.command[0][row];
    double& right = columns.command[1][row];
    if (in_millimetres) {
      left = with_sign(left);
      right = with_sign(right);
    }
    if (mapping.command->by_curvature) {
      const double apart = left * half_base * right * unit_m;
      right = left + apart;
      left -= apart;
      continue;
    }
    const auto special = in_millimetres ? special_arc(left, right) : std::nullopt;
    const WheelPair wheels = special.value_or(on_arc(left, right, half_base));
    left = wheels.left;
    right = wheels.right;
  }
}

void apply_directions(DriveColumns& columns, double forward) {
  for (std::size_t side = 0; side < 2; ++side) {
    const Column& bits = columns.direction[side];
    Column& command = columns.command[side];
    if (bits.empty() || command.empty()) continue;
    // Of signed directions 0 is neither.
    const bool can_stand = std::ranges::find(bits, -forward) != bits.end();
    double bit = forward;
    for (std::size_t row = 0; row < command.size(); ++row) {
      if (std::isfinite(bits[row])) bit = bits[row];
      if (bit == forward) continue;
      command[row] = can_stand && bit == 0.0 ? 0.0 * command[row] : -command[row];
    }
  }
}

}  // namespace wheelwright::import
