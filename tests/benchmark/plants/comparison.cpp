#include "tests/benchmark/plants/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "tests/benchmark/plants/least_squares.hpp"

namespace plants {

namespace {

constexpr double window_s = 0.25;
constexpr double memory_s = 1.0;
constexpr std::size_t lags = 12;

// A speed between two rows of the true motion.
using Speed = std::function<double(const Run& run, std::size_t from, std::size_t to)>;

double span_s(const Run& run, std::size_t from, std::size_t to) {
  return run.log.rows[to].time_s - run.log.rows[from].time_s;
}

Speed wheel_speed(std::size_t wheel) {
  return [wheel](const Run& run, std::size_t from, std::size_t to) {
    const long ticks = run.log.rows[to].ticks[wheel] - run.log.rows[from].ticks[wheel];
    return run.log.metres_per_tick * static_cast<double>(ticks) / span_s(run, from, to);
  };
}

// Speed of the reference point along a direction that is fixed to the body.
Speed point_speed(double bearing_rad) {
  return [bearing_rad](const Run& run, std::size_t from, std::size_t to) {
    const TrueRow& start = run.truth[from];
    const TrueRow& end = run.truth[to];
    const double direction_rad = bearing_rad + 0.5 * (start.heading_rad + end.heading_rad);
    return ((end.reference_point.x_m - start.reference_point.x_m) * std::cos(direction_rad) +
            (end.reference_point.y_m - start.reference_point.y_m) * std::sin(direction_rad)) /
           span_s(run, from, to);
  };
}

double turn_rate(const Run& run, std::size_t from, std::size_t to) {
  return (run.truth[to].heading_rad - run.truth[from].heading_rad) / span_s(run, from, to);
}

struct Difference {
  double rms;
  double bent_rms;
};

Difference difference(const std::vector<Run>& hidden, const std::vector<Run>& innocent, const Speed& speed) {
  LeastSquares fit(lags * wheel_count);
  for (std::size_t index = 0; index < hidden.size(); ++index) {
    const double period_s = hidden[index].log.period_s;
    const auto window_rows = static_cast<std::size_t>(std::lround(window_s / period_s));
    const auto memory_rows = static_cast<std::size_t>(std::lround(memory_s / period_s));
    for (std::size_t row = memory_rows; row < hidden[index].truth.size(); row += 2) {
      const double change =
          speed(hidden[index], row - window_rows, row) - speed(innocent[index], row - window_rows, row);
      fit.add(past_commands(hidden[index], row, memory_rows, lags), change);
    }
  }
  return {std::sqrt(fit.mean_square()), std::sqrt(fit.remaining_mean_square())};
}

}  // namespace

std::vector<double> past_commands(const Run& run, std::size_t row, std::size_t memory_rows,
                                  std::size_t lags) {
  std::vector<double> values;
  for (std::size_t lag = 0; lag < lags; ++lag)
    for (const double command_m_s : run.log.rows[row - lag * memory_rows / lags].command_m_s)
      values.push_back(command_m_s);
  return values;
}

Comparison compare(const std::vector<Run>& hidden, const std::vector<Run>& innocent,
                   const SensorSet& sensors) {
  const Difference left = difference(hidden, innocent, wheel_speed(left_side));
  const Difference right = difference(hidden, innocent, wheel_speed(right_side));
  const Difference forward = difference(hidden, innocent, point_speed(0.0));
  const Difference lateral = difference(hidden, innocent, point_speed(0.5 * std::numbers::pi));
  const Difference turn = difference(hidden, innocent, turn_rate);
  Comparison result;
  result.wheel_speed_m_s = std::max(left.rms, right.rms);
  result.wheel_bent_m_s = std::max(left.bent_rms, right.bent_rms);
  result.wheel_noise_m_s = hidden.front().log.metres_per_tick / std::sqrt(6.0) / window_s;
  result.lateral_speed_m_s = lateral.rms;
  result.forward_speed_m_s = forward.rms;
  result.forward_bent_m_s = forward.bent_rms;
  result.forward_noise_m_s = std::sqrt(2.0) * sensors.position_noise_m / window_s;
  result.turn_rate_rad_s = turn.rms;
  result.turn_bent_rad_s = turn.bent_rms;
  result.turn_noise_rad_s = std::sqrt(2.0) * sensors.heading_noise_rad / window_s;
  return result;
}

std::string comparison_header() {
  return "case,wheel_mm_s,wheel_bent,wheel_noise,lateral_mm_s,forward_mm_s,forward_bent,forward_noise,"
         "turn_mrad_s,turn_bent,turn_noise\n";
}

std::string comparison_line(const std::string& case_name, const Comparison& comparison) {
  char text[160];
  std::snprintf(text, sizeof text, ",%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.1f,%.1f\n",
                1000.0 * comparison.wheel_speed_m_s, 1000.0 * comparison.wheel_bent_m_s,
                1000.0 * comparison.wheel_noise_m_s, 1000.0 * comparison.lateral_speed_m_s,
                1000.0 * comparison.forward_speed_m_s, 1000.0 * comparison.forward_bent_m_s,
                1000.0 * comparison.forward_noise_m_s, 1000.0 * comparison.turn_rate_rad_s,
                1000.0 * comparison.turn_bent_rad_s, 1000.0 * comparison.turn_noise_rad_s);
  return case_name + text;
}

}  // namespace plants
