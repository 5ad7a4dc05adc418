#include "tools/wheelwright/import/conversion/clock_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/reference_poses.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {
namespace {

// Speeds are taken over these windows, the next one where the one before says nothing: poses that scatter by
// a centimetre show a speed over a second, and none over a tenth of it.
constexpr std::array windows_s{0.1, 0.3, 1.0, 3.0};
constexpr double fine_s = 0.01;
constexpr double min_overlap_s = 5.0;
constexpr double min_correlation = 0.5;
constexpr std::size_t max_points = 40'000;  // more than an hour

struct Grid {
  double step_s = 0.0;
  double window_s = 0.0;  // a whole number of steps
};

// A mean speed over windows, on an even grid.
struct Speeds {
  double start_s = 0.0;
  std::vector<double> values;
};

// Of a way along a path that was sampled at any times.
Speeds on_grid(const std::vector<double>& t_s, const std::vector<double>& way, const Grid& grid) {
  Speeds speeds;
  if (t_s.size() < 2) return speeds;
  speeds.start_s = t_s.front();
  const auto points =
      std::min(max_points, static_cast<std::size_t>((t_s.back() - t_s.front()) / grid.step_s));
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
  if (!t_s.empty() && t <= t_s.back()) return;
  t_s.push_back(t);
  way.push_back((way.empty() ? 0.0 : way.back()) + std::abs(distance));
}

Speeds reference_speeds(std::span<const Recording> recordings, const Mapping& mapping, const Grid& grid) {
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

// Of the middle of the wheels, in any unit.
Speeds robot_speeds(std::span<const Recording> recordings, const Mapping& mapping, const Grid& grid) {
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
      return travel.values[1].empty() || mapping.wheels->body_motion ? left
                                                                     : 0.5 * (left + travel.values[1][i]);
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
  double held = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    add_point(times, way, columns->t_s[i], times.empty() ? 0.0 : held * (columns->t_s[i] - times.back()));
    const double first = columns->command[0].empty() ? held : columns->command[0][i];
    if (std::isfinite(first)) held = first;
  }
  return on_grid(times, way, grid);
}

// Correlation of a[i] and b[i - shift] where both are, 0 where less than half of the shorter is.
double correlation(const Speeds& a, const Speeds& b, long shift) {
  const auto size_a = static_cast<long>(a.values.size());
  const auto size_b = static_cast<long>(b.values.size());
  const long begin = std::max(0L, shift);
  const long end = std::min(size_a, size_b + shift);
  if (2 * (end - begin) < std::min(size_a, size_b)) return 0.0;
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (long i = begin; i < end; ++i) {
    const double va = a.values[static_cast<std::size_t>(i)];
    const double vb = b.values[static_cast<std::size_t>(i - shift)];
    n += 1;
    sa += va;
    sb += vb;
    saa += va * va;
    sbb += vb * vb;
    sab += va * vb;
  }
  const double variances = (saa - sa * sa / n) * (sbb - sb * sb / n);
  return variances > 0.0 ? (sab - sa * sb / n) / std::sqrt(variances) : 0.0;
}

struct Best {
  long shift = 0;
  double correlation = 0.0;
};

Best best_shift(const Speeds& robot, const Speeds& reference, long from, long to) {
  Best best;
  for (long shift = from; shift <= to; ++shift) {
    const double found = correlation(robot, reference, shift);
    if (found > best.correlation) best = {shift, found};
  }
  return best;
}

// Over all shifts of whole windows.
Best coarse_shift(const Speeds& robot, const Speeds& reference) {
  return best_shift(robot, reference, -static_cast<long>(reference.values.size()),
                    static_cast<long>(robot.values.size()));
}

std::string said_to_begin_together(const Speeds& robot, const Speeds& reference) {
  return "if both began together: --set reference.shift_s=" +
         config::fixed_number(robot.start_s - reference.start_s, 3);
}

}  // namespace

tl::expected<ClockShift, std::string> find_clock_shift(std::span<const Recording> recordings,
                                                       const Mapping& mapping) {
  if (!mapping.reference->x || !mapping.reference->y)
    return tl::unexpected(std::string(
        "a reference without places has no clock to compare; give its shift: --set reference.shift_s=0"));
  const FoundChannel x = find_channel(recordings, *mapping.reference->x);
  if (x.stream != nullptr && stream_times(*x.stream, mapping.time).empty())
    return tl::unexpected(std::string(
        "the reference has no time; say how far its rows or frames are apart: --set time.rate_hz=100"));
  double most = 0.0;
  std::string together;
  for (const double window_s : windows_s) {
    const Grid coarse_grid{window_s, window_s};
    const Speeds robot = robot_speeds(recordings, mapping, coarse_grid);
    const Speeds reference = reference_speeds(recordings, mapping, coarse_grid);
    const auto overlap = static_cast<double>(std::min(robot.values.size(), reference.values.size()));
    if (overlap * window_s < min_overlap_s) {
      return tl::unexpected(
          "too little of the robot or its reference moves to compare their clocks; give the shift; " +
          said_to_begin_together(robot, reference));
    }
    const Best coarse = coarse_shift(robot, reference);
    most = std::max(most, coarse.correlation);
    together = said_to_begin_together(robot, reference);
    if (coarse.correlation < min_correlation) continue;
    const Grid grid{fine_s, window_s};
    const long per_window = std::lround(window_s / fine_s);
    const Best fine =
        best_shift(robot_speeds(recordings, mapping, grid), reference_speeds(recordings, mapping, grid),
                   (coarse.shift - 2) * per_window, (coarse.shift + 2) * per_window);
    const long shift = fine.correlation > 0.0 ? fine.shift : coarse.shift * per_window;
    ClockShift result;
    result.seconds = robot.start_s - reference.start_s + fine_s * static_cast<double>(shift);
    result.evidence = "the clock of the reference is shifted by " + config::fixed_number(result.seconds, 3) +
                      " s: there its speed and that of the robot agree best (correlation " +
                      config::fixed_number(coarse.correlation, 2) + ")";
    return result;
  }
  return tl::unexpected(
      "the speed of the reference fits that of the robot at no shift of its clock (correlation " +
      config::fixed_number(most, 2) + " at best); give the shift; " + together);
}

}  // namespace wheelwright::import
