#include "tools/wheelwright/import/conversion/clock_speeds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/reference_poses.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {
namespace {

// Of a way along a path that was sampled at any times.
GridSpeeds on_grid(const std::vector<double>& t_s, const std::vector<double>& way, const SpeedGrid& grid) {
  GridSpeeds speeds;
  if (t_s.size() < 2) return speeds;
  speeds.start_s = t_s.front();
  const auto points =
      std::min(grid.max_points, static_cast<std::size_t>((t_s.back() - t_s.front()) / grid.step_s));
  std::vector<double> on_points{way.front()};
  std::size_t at = 0;
  for (std::size_t i = 1; i <= points; ++i) {
    const double t = speeds.start_s + grid.step_s * static_cast<double>(i);
    while (at + 2 < t_s.size() && t_s[at + 1] < t) ++at;
    const double part = std::clamp((t - t_s[at]) / (t_s[at + 1] - t_s[at]), 0.0, 1.0);
    on_points.push_back(way[at] + part * (way[at + 1] - way[at]));
  }
  const auto window = static_cast<std::size_t>(std::lround(grid.window_s / grid.step_s));
  for (std::size_t i = window; i < on_points.size(); ++i)
    speeds.values.push_back((on_points[i] - on_points[i - window]) / grid.window_s);
  return speeds;
}

void add_point(std::vector<double>& t_s, std::vector<double>& way, double t, double distance) {
  if (!std::isfinite(t) || (!t_s.empty() && t <= t_s.back())) return;
  t_s.push_back(t);
  way.push_back((way.empty() ? 0.0 : way.back()) + std::abs(distance));
}

}  // namespace

GridSpeeds reference_speeds(std::span<const Recording> recordings, const Mapping& mapping,
                            const SpeedGrid& grid) {
  const auto poses = reference_poses(recordings, *mapping.reference);
  if (!poses || poses->x.stream == nullptr || poses->x.stream != poses->y.stream) return {};
  const auto t_s = stream_times(*poses->x.stream, mapping.time);
  const Column& xs = poses->x.values;
  const Column& ys = poses->y.values;
  std::vector<double> times;
  std::vector<double> way;
  std::size_t last = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    if (!std::isfinite(t_s[i]) || !std::isfinite(xs[i]) || !std::isfinite(ys[i])) continue;
    // Noise adds to a way that is summed over short steps.
    if (!times.empty() && t_s[i] < times.back() + 0.5 * grid.window_s) continue;
    add_point(times, way, t_s[i], times.empty() ? 0.0 : std::hypot(xs[i] - xs[last], ys[i] - ys[last]));
    last = i;
  }
  return on_grid(times, way, grid);
}

GridSpeeds robot_speeds(std::span<const Recording> recordings, const Mapping& mapping,
                        const SpeedGrid& grid) {
  Mapping robot = mapping;
  robot.reference.reset();
  const auto columns = gather(recordings, robot);
  if (!columns) return {};
  std::vector<double> times;
  std::vector<double> way;
  std::vector<std::size_t> rows(columns->rows());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  if (mapping.wheels) {
    const WheelTravel travel = wheel_travel(*columns, rows, mapping);
    const bool is_speed = mapping.wheels->kind == WheelKind::speed;
    const auto middle = [&](std::size_t i) {
      const double left = travel.values[0][i];
      return travel.values[1].empty() ? left : 0.5 * (left + travel.values[1][i]);
    };
    double last = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!std::isfinite(columns->t_s[i]) || !std::isfinite(middle(i))) continue;
      const double duration_s = times.empty() ? 0.0 : columns->t_s[i] - times.back();
      add_point(times, way, columns->t_s[i],
                times.empty() ? 0.0
                : is_speed    ? middle(i) * duration_s
                              : middle(i) - last);
      last = middle(i);
    }
    return on_grid(times, way, grid);
  }
  std::array<double, 2> held{0.0, 0.0};
  const bool are_sides = mapping.command && !mapping.command->is_of_body() && !columns->command[1].empty();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!std::isfinite(columns->t_s[i])) continue;
    const double speed = are_sides ? 0.5 * (held[0] + held[1]) : held[0];
    add_point(times, way, columns->t_s[i], times.empty() ? 0.0 : speed * (columns->t_s[i] - times.back()));
    for (std::size_t side = 0; side < 2; ++side) {
      const Column& command = columns->command.at(side);
      if (!command.empty() && std::isfinite(command[i])) held.at(side) = command[i];
    }
  }
  return on_grid(times, way, grid);
}

}  // namespace wheelwright::import
