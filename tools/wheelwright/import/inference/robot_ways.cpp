#include "tools/wheelwright/import/inference/robot_ways.hpp"

#include <cmath>

#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {

std::optional<WayBy> way_source(const DriveColumns& columns, const Mapping& mapping) {
  const bool has_wheels = mapping.wheels && mapping.wheels->right &&
                          mapping.wheels->kind != WheelKind::speed && !columns.wheel[1].empty();
  if (!mapping.wheel_base_m) return std::nullopt;
  if (has_wheels) return wheel_scale(*mapping.wheels) ? std::optional(WayBy::wheels) : std::nullopt;
  const bool has_speeds = mapping.command && !columns.command[0].empty() &&
                          (!mapping.command->is_duty() || mapping.command->full_scale_m_s.has_value());
  return has_speeds ? std::optional(WayBy::commands) : std::nullopt;
}

double Ways::chord(std::size_t from, std::size_t to) const {
  const double half_turn = 0.5 * (turn[to] - turn[from]);
  const double share = std::abs(half_turn) > 1e-6 ? std::sin(half_turn) / half_turn : 1.0;
  return std::abs(share * (way[to] - way[from]));
}

std::vector<Window> windows_of(const DriveColumns& columns, std::span<const std::size_t> rows,
                               const std::vector<char>& is_known) {
  constexpr double window_s = 1.0;
  std::vector<Window> windows;
  std::size_t from = rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_known[i] == 0) continue;
    if (from < rows.size()) {
      if (columns.t_s[rows[i]] - columns.t_s[rows[from]] < window_s) continue;
      windows.push_back({from, i});
    }
    from = i;
  }
  return windows;
}

void Agreement::add(double robot, double reference) {
  products += robot * reference;
  robot_squares += robot * robot;
  reference_squares += reference * reference;
  ++windows;
}

double Agreement::correlation() const {
  const double squares = robot_squares * reference_squares;
  return squares > 0.0 ? products / std::sqrt(squares) : 0.0;
}

bool Agreement::holds() const {
  constexpr std::size_t min_windows = 10;
  constexpr double min_correlation = 0.8;
  return windows >= min_windows && correlation() >= min_correlation;
}

Ways ways_of_robot(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
                   WayBy source) {
  Ways ways(rows.size());
  const double base_m = *mapping.wheel_base_m;
  if (source == WayBy::wheels) {
    const double scale = *wheel_scale(*mapping.wheels);
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    const double left = mapping.wheels->left_reversed ? -scale : scale;
    const double right = mapping.wheels->right_reversed ? -scale : scale;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double left_m = left * travel.values[0][i];
      const double right_m = right * travel.values[1][i];
      ways.way[i] = 0.5 * (left_m + right_m);
      ways.turn[i] = (right_m - left_m) / base_m;
    }
    return ways;
  }
  const auto commands = wheel_commands(columns, rows, mapping);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double duration_s = columns.t_s[rows[i]] - columns.t_s[rows[i - 1]];
    const double left_m = duration_s * commands[0][i - 1];
    const double right_m = duration_s * commands[1][i - 1];
    const bool is_known = std::isfinite(left_m) && std::isfinite(right_m);
    ways.way[i] = ways.way[i - 1] + (is_known ? 0.5 * (left_m + right_m) : 0.0);
    ways.turn[i] = ways.turn[i - 1] + (is_known ? (right_m - left_m) / base_m : 0.0);
  }
  return ways;
}

}  // namespace wheelwright::import
