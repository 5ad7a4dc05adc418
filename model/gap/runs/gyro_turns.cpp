#include "model/gap/runs/gyro_turns.hpp"

#include <algorithm>

namespace wheelwright::gap {
namespace {

constexpr double nearly_all = 0.95;     // of the rows
constexpr double longest_gap_s = 0.25;  // over which a rate may be carried on

}  // namespace

bool has_gyro(const DriveLog& log) {
  std::size_t rates = 0;
  double last_s = log.samples.empty() ? 0.0 : log.samples.front().t_s;
  for (const DriveSample& sample : log.samples) {
    if (!sample.gyro_z_rad_s) continue;
    if (sample.t_s - last_s > longest_gap_s) return false;
    last_s = sample.t_s;
    ++rates;
  }
  return rates > 1 && static_cast<double>(rates) >= nearly_all * static_cast<double>(log.samples.size());
}

std::vector<GyroTurn> gyro_turns(const DriveLog& log) {
  std::vector<GyroTurn> turns;
  if (!has_gyro(log)) return turns;
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const DriveSample& now = log.samples[row];
    if (!now.gyro_z_rad_s) continue;
    if (turns.empty()) {
      turns.push_back({row, 0.0});
      continue;
    }
    const DriveSample& before = log.samples[turns.back().row];
    const double rate_rad_s = 0.5 * (*before.gyro_z_rad_s + *now.gyro_z_rad_s);
    turns.push_back({row, turns.back().turned_rad + rate_rad_s * (now.t_s - before.t_s)});
  }
  return turns;
}

GyroErrors without_drift(const GapRun& run, std::vector<double> errors_rad) {
  const Series& series = run[Channel::turn];
  double products = 0.0;
  double sum_squares = 0.0;
  for (std::size_t i = 1; i < errors_rad.size(); ++i) {
    if (series.restarts[i]) continue;
    const double duration_s = seconds_at(run, series.at[i]) - seconds_at(run, series.at[i - 1]);
    products += duration_s * (errors_rad[i] - errors_rad[i - 1]);
    sum_squares += duration_s * duration_s;
  }
  const double drift_rad_s = sum_squares > 0.0 ? products / sum_squares : 0.0;
  for (std::size_t i = 0; i < errors_rad.size(); ++i)
    errors_rad[i] -= drift_rad_s * seconds_at(run, series.at[i]);
  return {std::move(errors_rad), drift_rad_s};
}

void lay_gyro_headings(DriveLog& log, double drift_rad_s, double scale) {
  const auto turns = gyro_turns(log);
  if (turns.empty()) return;
  const double start_s = log.samples[turns.front().row].t_s;
  for (const auto& [row, turned_rad] : turns) {
    DriveSample& sample = log.samples[row];
    sample.reference_theta_rad = (turned_rad - drift_rad_s * (sample.t_s - start_s)) / (1.0 + scale);
  }
}

}  // namespace wheelwright::gap
