#include "tools/wheelwright/import/conversion/run_maker.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "config/load/drive_log_file.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/command_holes.hpp"
#include "tools/wheelwright/import/conversion/missing_keys.hpp"
#include "tools/wheelwright/import/conversion/reference_poses.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;

// Of distances that were no counts: fine enough to add no noise to what an encoder shows.
constexpr double fine_count_m = 1e-6;
// One wheel has no base; the other stands still beside it.
constexpr double one_wheel_base_m = 1.0;

std::optional<double> value(const Column& column, std::size_t row) {
  if (column.empty() || !std::isfinite(column[row])) return std::nullopt;
  return column[row];
}

double gyro_in_rad_s(const ScalarMapping& gyro) {
  if (gyro.unit != raw_unit) return in_si(angular_units(), gyro.unit);
  return in_si(angular_units(), "deg/s") / gyro.lsb_per_deg_s.value_or(1.0);
}

class RunMaker {
 public:
  RunMaker(const DriveColumns& columns, const Column& times_s, const Mapping& mapping,
           const std::string& name)
      : columns_(columns), times_s_(times_s), mapping_(mapping), name_(name) {}

  DriveLog make(const RunRows& rows, std::vector<std::string>& remarks) {
    DriveLog log;
    log.name = name_;
    log.wheel_base_m = mapping_.wheel_base_m.value_or(one_wheel_base_m);
    log.first_line = rows.front() < columns_.places.size() ? columns_.places[rows.front()] : rows.front() + 1;
    std::vector<double> t_s;
    t_s.reserve(rows.size());
    for (const std::size_t row : rows) t_s.push_back(times_s_[row] - times_s_[rows.front()]);
    std::array<Column, 2> counts = wheel_counts(rows, t_s, log, remarks);
    name_holes(rows, t_s, remarks);
    name_command_holes(rows, t_s, remarks);
    make_samples(rows, t_s, counts, log, remarks);
    log.period_s = mapping_.time.period_s ? *mapping_.time.period_s : period_of(log);
    return log;
  }

 private:
  // Counts per wheel; `t_s` becomes even where its stamps are not to be believed.
  std::array<Column, 2> wheel_counts(const RunRows& rows, std::vector<double>& t_s, DriveLog& log,
                                     std::vector<std::string>& remarks) const {
    if (!mapping_.wheels) return {};
    const WheelMapping& wheels = *mapping_.wheels;
    WheelTravel travel = wheel_travel(columns_, rows, mapping_);
    remarks.insert(remarks.end(), travel.remarks.begin(), travel.remarks.end());
    if (wheels.kind != WheelKind::speed) make_even(rows, travel, t_s, remarks);
    const double scale = wheel_scale(wheels).value_or(1.0);
    if (wheels.kind == WheelKind::counts) {
      log.metres_per_tick = WheelPair{scale, wheels.metres_per_count_right.value_or(scale)};
    } else {
      to_fine_counts(travel.values, t_s, scale);
      log.metres_per_tick = WheelPair{fine_count_m, fine_count_m};
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (side == 0 ? !wheels.left_reversed : !wheels.right_reversed) continue;
      for (double& count : travel.values[side]) count = -count;
    }
    return travel.values;
  }

  void name_holes(const RunRows& rows, const std::vector<double>& t_s,
                  std::vector<std::string>& remarks) const {
    constexpr std::size_t max_named = 5;
    const double longest_s = std::max(0.3, 5.0 * median_step_s(t_s));
    std::size_t count = 0;
    for (std::size_t i = 1; i < t_s.size(); ++i) {
      if (t_s[i] - t_s[i - 1] <= longest_s || ++count > max_named) continue;
      remarks.push_back(columns_.place(rows[i]) + ": no rows for " + fixed_number(t_s[i] - t_s[i - 1], 3) +
                        " s");
    }
    if (count > max_named) remarks.push_back("and " + std::to_string(count - max_named) + " more holes");
  }

  void name_command_holes(const RunRows& rows, const std::vector<double>& t_s,
                          std::vector<std::string>& remarks) const {
    if (mapping_.command->timeout_s) return;
    for (const CommandHole& hole : command_holes(columns_, rows, t_s))
      remarks.push_back(
          columns_.place(rows[hole.row]) + ": no command for " + fixed_number(hole.duration_s, 1) +
          " s behind it; it is taken to hold. If the robot stopped by itself, say after what time: --set "
          "command.timeout_s=0.5");
  }

  void make_even(const RunRows& rows, const WheelTravel& travel, std::vector<double>& t_s,
                 std::vector<std::string>& remarks) const {
    const auto even = even_stamps(t_s, travel.values[0]);
    if (!even) return;
    remarks.push_back(columns_.place(rows.front()) + ": " + even->text());
    t_s = even->t_s;
  }

  // Angles, distances or speeds as counts of a micrometre.
  void to_fine_counts(std::array<Column, 2>& values, const std::vector<double>& t_s, double scale) const {
    const WheelMapping& wheels = *mapping_.wheels;
    const double factor = scale / fine_count_m;
    for (Column& side : values) {
      if (wheels.kind == WheelKind::speed) integrate(side, t_s);
      for (double& entry : side) entry = std::isfinite(entry) ? std::round(entry * factor) : entry;
    }
  }

  // A speed is that of the time since the row before.
  static void integrate(Column& values, const std::vector<double>& t_s) {
    double sum = 0.0;
    double last_s = t_s.front();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) continue;
      sum += values[i] * (t_s[i] - last_s);
      last_s = t_s[i];
      values[i] = sum;
    }
  }

  void make_samples(const RunRows& rows, const std::vector<double>& t_s, const std::array<Column, 2>& counts,
                    DriveLog& log, std::vector<std::string>& remarks) const {
    const bool one_command = columns_.command[1].empty();
    const bool is_of_body = mapping_.command->is_of_body();
    std::optional<double> first;
    std::optional<double> second;
    std::size_t before_commands = 0;
    log.samples.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t row = rows[i];
      if (const auto said = value(columns_.command[0], row)) first = said;
      if (one_command) {
        second = is_of_body ? std::optional(0.0) : first;
      } else if (const auto said = value(columns_.command[1], row)) {
        second = said;
      }
      if (!first || !second) {
        ++before_commands;
        continue;
      }
      WheelPair command_m_s = wheel_command(mapping_, *first, *second);
      if (is_one_wheel(mapping_)) command_m_s.right = 0.0;
      log.samples.push_back(sample(row, t_s[i], command_m_s));
      add_counts(counts, i, log.samples.back());
    }
    if (is_one_wheel(mapping_) && !one_command && !is_of_body)
      remarks.push_back(
          columns_.place(rows.front()) +
          ": the right wheel has no counter, and is left out with its command: one wheel alone");
    if (before_commands > 0) {
      remarks.push_back(columns_.place(rows.front()) + ": " + std::to_string(before_commands) +
                        " rows before the first command, left out");
    }
    trim_to_counts(log);
    const double start_s = log.samples.empty() ? 0.0 : log.samples.front().t_s;
    for (auto& entry : log.samples) entry.t_s -= start_s;
  }

  // A run of counts begins and ends with one; the last command before it is in force there.
  static void trim_to_counts(DriveLog& log) {
    const auto first =
        std::ranges::find_if(log.samples, [](const DriveSample& entry) { return entry.ticks.has_value(); });
    if (first == log.samples.end()) return;
    log.samples.erase(log.samples.begin(), first);
    while (!log.samples.back().ticks) log.samples.pop_back();
  }

  DriveSample sample(std::size_t row, double t_s, const WheelPair& command_m_s) const {
    DriveSample result;
    result.t_s = t_s;
    result.command_m_s = command_m_s;
    if (mapping_.reference) {
      const double metres = place_in_m(*mapping_.reference);
      if (const auto x = value(columns_.x, row)) result.reference_x_m = metres * *x;
      if (const auto y = value(columns_.y, row)) result.reference_y_m = metres * *y;
      result.reference_theta_rad = value(columns_.theta_rad, row);
    }
    if (const auto gyro = value(columns_.gyro, row)) {
      result.gyro_z_rad_s = gyro_in_rad_s(*mapping_.gyro) * *gyro;
    }
    if (const auto battery = value(columns_.battery, row)) {
      result.battery_v = in_si(voltage_units(), mapping_.battery->unit) * *battery;
    }
    return result;
  }

  static void add_counts(const std::array<Column, 2>& counts, std::size_t at, DriveSample& sample) {
    const auto is_count = [](double value) { return std::abs(value) <= config::largest_tick_count; };
    if (counts[0].empty() || !is_count(counts[0][at])) return;
    const double right = counts[1].empty() ? 0.0 : counts[1][at];
    if (is_count(right)) sample.ticks = WheelTicks{std::llround(counts[0][at]), std::llround(right)};
  }

  // Of the rows that measured something: rows that hold a command alone lie anywhere.
  static double period_of(const DriveLog& log) {
    std::vector<double> counted;
    std::vector<double> placed;
    std::vector<double> all;
    for (const auto& sample : log.samples) {
      all.push_back(sample.t_s);
      if (sample.ticks) counted.push_back(sample.t_s);
      if (sample.reference_x_m || sample.reference_theta_rad) placed.push_back(sample.t_s);
    }
    // To a tenth of a microsecond: stamps have no more.
    return std::round(1e7 * median_step_s(counted.size() > 2  ? counted
                                          : placed.size() > 2 ? placed
                                                              : all)) /
           1e7;
  }

  const DriveColumns& columns_;
  const Column& times_s_;
  const Mapping& mapping_;
  const std::string& name_;
};

}  // namespace

DriveLog make_run(const DriveColumns& columns, const Column& times_s, const Mapping& mapping,
                  const std::string& name, const RunRows& rows, std::vector<std::string>& remarks) {
  return RunMaker(columns, times_s, mapping, name).make(rows, remarks);
}

}  // namespace wheelwright::import
