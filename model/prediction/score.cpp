#include "model/prediction/score.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelwright {
namespace {

constexpr double horizon_tolerance = 0.05;  // of the horizon, where references do not fall on its end

template <typename Predicate>
std::vector<std::size_t> rows_where(const DriveLog& log, Predicate predicate) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (predicate(log.samples[k])) rows.push_back(k);
  }
  return rows;
}

std::vector<std::size_t> rows_with_ticks(const DriveLog& log) {
  if (!log.metres_per_tick) return {};
  return rows_where(log, [](const DriveSample& sample) { return sample.ticks.has_value(); });
}

WheelPair travelled_m(const DriveLog& log, std::size_t from, std::size_t to) {
  const WheelTicks& a = *log.samples[from].ticks;
  const WheelTicks& b = *log.samples[to].ticks;
  return {static_cast<double>(b.left - a.left) * log.metres_per_tick->left,
          static_cast<double>(b.right - a.right) * log.metres_per_tick->right};
}

// Predicted minus measured travel of the wheels from one row to another.
WheelPair travel_error_m(Prediction predicted, const DriveLog& measured, std::size_t from, std::size_t to) {
  const WheelPair travelled = travelled_m(measured, from, to);
  const WheelPair& a = predicted[from].distance_m;
  const WheelPair& b = predicted[to].distance_m;
  return {b.left - a.left - travelled.left, b.right - a.right - travelled.right};
}

struct Window {
  std::size_t from;
  std::size_t to;
};

struct Windows {
  double horizon_s = 0.0;
  std::vector<Window> windows;
};

// Windows between the given rows of a log.
Windows windows_between(const DriveLog& log, const std::vector<std::size_t>& rows) {
  if (rows.size() < 2) return {};
  const auto time = [&](std::size_t i) { return log.samples[rows[i]].t_s; };
  const double span = time(rows.size() - 1) - time(0);
  Windows result{std::min(longest_horizon_s, span), {}};
  double next_start = time(0);
  std::size_t end = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (time(i) < next_start) continue;
    while (next_start <= time(i)) next_start += between_windows_s;
    const double wanted = time(i) + result.horizon_s;
    while (end + 1 < rows.size() && std::abs(time(end + 1) - wanted) <= std::abs(time(end) - wanted)) ++end;
    if (std::abs(time(end) - wanted) > horizon_tolerance * result.horizon_s) continue;
    result.windows.push_back({rows[i], rows[end]});
  }
  if (result.windows.empty()) return {span, {{rows.front(), rows.back()}}};
  return result;
}

Prediction told_last_at(std::size_t row, std::span<const Prediction> runs) {
  return *std::ranges::min_element(runs, {}, [row](Prediction run) { return run[row].free_for_s; });
}

}  // namespace

void ScoreSums::Sum::add(double error) {
  squares += error * error;
  ++count;
}

std::optional<double> ScoreSums::Sum::rms() const {
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(count));
}

std::optional<AtHorizon> ScoreSums::SumAtHorizon::rms() const {
  const auto value = errors.rms();
  if (!value) return std::nullopt;
  return AtHorizon{horizons_s / static_cast<double>(errors.count), *value};
}

void ScoreSums::add(Prediction predicted, const DriveLog& measured) {
  add({&predicted, 1}, measured);
}

void ScoreSums::add(std::span<const Prediction> runs, const DriveLog& measured) {
  add_wheels(runs.front(), measured);
  add_poses(runs, measured);
  add_headings(runs, measured);
}

void ScoreSums::add_wheels(Prediction predicted, const DriveLog& measured) {
  const auto rows = rows_with_ticks(measured);
  std::size_t begin = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (measured.samples[rows[i]].counter_reset) {
      begin = i;
      continue;
    }
    const double duration_s = measured.samples[rows[i]].t_s - measured.samples[rows[i - 1]].t_s;
    const WheelPair step = travel_error_m(predicted, measured, rows[i - 1], rows[i]);
    wheel_speed_m_s_.add(step.left / duration_s);
    wheel_speed_m_s_.add(step.right / duration_s);
    const WheelPair total = travel_error_m(predicted, measured, rows[begin], rows[i]);
    distance_m_.add(total.left);
    distance_m_.add(total.right);
  }
}

void ScoreSums::add_poses(std::span<const Prediction> runs, const DriveLog& measured) {
  const auto rows =
      rows_where(measured, [](const DriveSample& sample) { return sample.reference_pose().has_value(); });
  const Windows found = windows_between(measured, rows);
  for (const auto& [from, to] : found.windows) {
    const Pose moved = between(measured.samples[from].reference_pose().value(),
                               measured.samples[to].reference_pose().value());
    const Prediction predicted = told_last_at(from, runs);
    const Pose expected = between(predicted[from].pose, predicted[to].pose);
    position_m_.errors.add(distance_between_m(expected, moved));
    position_m_.horizons_s += found.horizon_s;
  }
}

void ScoreSums::add_headings(std::span<const Prediction> runs, const DriveLog& measured) {
  const auto rows =
      rows_where(measured, [](const DriveSample& sample) { return sample.reference_theta_rad.has_value(); });
  const Windows found = windows_between(measured, rows);
  for (const auto& [from, to] : found.windows) {
    const double turned =
        *measured.samples[to].reference_theta_rad - *measured.samples[from].reference_theta_rad;
    const Prediction predicted = told_last_at(from, runs);
    const double expected = predicted[to].pose.theta_rad - predicted[from].pose.theta_rad;
    heading_rad_.errors.add(wrap_angle(expected - turned));
    heading_rad_.horizons_s += found.horizon_s;
  }
}

Score ScoreSums::score() const {
  return {wheel_speed_m_s_.rms(), distance_m_.rms(), position_m_.rms(), heading_rad_.rms()};
}

Score score_run(Prediction predicted, const DriveLog& measured) {
  ScoreSums sums;
  sums.add(predicted, measured);
  return sums.score();
}

std::optional<WheelPair> end_distance_error_m(Prediction predicted, const DriveLog& measured) {
  const auto rows = rows_with_ticks(measured);
  if (rows.size() < 2) return std::nullopt;
  return travel_error_m(predicted, measured, rows.front(), rows.back());
}

}  // namespace wheelwright
