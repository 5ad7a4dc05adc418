#include "tools/wheelwright/import/conversion/convert.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;

// Of distances that were no counts: fine enough to add no noise to what an encoder shows.
constexpr double fine_count_m = 1e-6;
// One wheel has no base; the other stands still beside it.
constexpr double one_wheel_base_m = 1.0;

double in_si(std::span<const Unit> units, const std::string& name) {
  const auto unit = find_unit(units, name);
  return unit ? unit->in_si : 1.0;
}

std::optional<double> value(const Column& column, std::size_t row) {
  if (column.empty() || !std::isfinite(column[row])) return std::nullopt;
  return column[row];
}

bool are_alike(const DriveColumns& columns, std::size_t a, std::size_t b) {
  const std::array<const Column*, 9> all{&columns.command[0], &columns.command[1], &columns.wheel[0],
                                         &columns.wheel[1],   &columns.x,          &columns.y,
                                         &columns.theta_rad,  &columns.gyro,       &columns.battery};
  return std::ranges::all_of(all, [&](const Column* column) {
    if (column->empty()) return true;
    const double first = (*column)[a];
    const double second = (*column)[b];
    return first == second || (std::isnan(first) && std::isnan(second));
  });
}

// By the command; by the counts beside it where there is none.
bool is_at_rest(const DriveColumns& columns, std::size_t row) {
  if (!columns.command[0].empty()) {
    return std::ranges::all_of(columns.command, [row](const Column& command) {
      return command.empty() || std::isnan(command[row]) || command[row] == 0.0;
    });
  }
  const std::size_t other = row > 0 ? row - 1 : row + 1;
  return std::ranges::all_of(columns.wheel, [&](const Column& wheel) {
    return wheel.empty() || other >= wheel.size() || wheel[row] == wheel[other];
  });
}

double median_step(const std::vector<double>& times_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times_s.size(); ++i) steps.push_back(times_s[i] - times_s[i - 1]);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool is_one_wheel(const Mapping& mapping) {
  return mapping.wheels && !mapping.wheels->right && !mapping.wheels->body_motion && !mapping.reference;
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
    for (const std::size_t row : rows) t_s.push_back(times_s_[row] - times_s_[rows.front()]);
    std::array<Column, 2> counts = wheel_counts(rows, t_s, log, remarks);
    name_holes(rows, t_s, remarks);
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
    WheelTravel travel = wheel_travel(columns_, rows, wheels);
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
    constexpr std::size_t most_named = 5;
    const double longest_s = std::max(0.3, 5.0 * median_step(t_s));
    std::size_t count = 0;
    for (std::size_t i = 1; i < t_s.size(); ++i) {
      if (t_s[i] - t_s[i - 1] <= longest_s || ++count > most_named) continue;
      remarks.push_back(columns_.place(rows[i]) + ": no rows for " + fixed_number(t_s[i] - t_s[i - 1], 3) +
                        " s");
    }
    if (count > most_named) remarks.push_back("and " + std::to_string(count - most_named) + " more holes");
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
    if (wheels.body_motion) to_wheels(values);
    const double factor = (wheels.body_motion ? 1.0 : scale) / fine_count_m;
    for (Column& side : values) {
      if (wheels.kind == WheelKind::speed) integrate(side, t_s);
      for (double& entry : side) entry = std::isfinite(entry) ? std::round(entry * factor) : entry;
    }
  }

  void to_wheels(std::array<Column, 2>& values) const {
    const double linear = in_si(speed_units(), mapping_.wheels->unit);
    const double half_base_m = 0.5 * *mapping_.wheel_base_m;
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      const double forward = linear * values[0][i];
      const double turning = values[1].empty() ? 0.0 : half_base_m * values[1][i];
      values[0][i] = forward - turning;
      if (!values[1].empty()) values[1][i] = forward + turning;
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

  WheelPair command(double first, double second) const {
    const CommandMapping& command = *mapping_.command;
    switch (command.kind) {
      case CommandKind::duty: {
        const double factor = command.full_scale_m_s.value_or(1.0) / command.full_scale;
        return {factor * first, factor * second};
      }
      case CommandKind::twist: {
        const double forward = in_si(speed_units(), command.unit) * first;
        const double turning =
            0.5 * *mapping_.wheel_base_m * in_si(angular_units(), command.angular_unit) * second;
        return {forward - turning, forward + turning};
      }
      case CommandKind::wheels:
        break;
    }
    const auto unit = find_unit(speed_units(), command.unit);
    const double radius_m = unit && unit->of_wheel
                                ? (mapping_.wheels ? mapping_.wheels->wheel_radius_m.value_or(1.0) : 1.0)
                                : 1.0;
    const double factor = (unit ? unit->in_si : 1.0) * radius_m;
    return {factor * first, factor * second};
  }

  void make_samples(const RunRows& rows, const std::vector<double>& t_s, const std::array<Column, 2>& counts,
                    DriveLog& log, std::vector<std::string>& remarks) const {
    const bool one_command = columns_.command[1].empty();
    const bool is_twist = mapping_.command->kind == CommandKind::twist;
    std::optional<double> first;
    std::optional<double> second;
    std::size_t before_commands = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t row = rows[i];
      if (const auto said = value(columns_.command[0], row)) first = said;
      if (one_command) {
        second = is_twist ? std::optional(0.0) : first;
      } else if (const auto said = value(columns_.command[1], row)) {
        second = said;
      }
      if (!first || !second) {
        ++before_commands;
        continue;
      }
      WheelPair command_m_s = command(*first, *second);
      if (is_one_wheel(mapping_)) command_m_s.right = 0.0;
      log.samples.push_back(sample(row, t_s[i], command_m_s));
      add_counts(counts, i, log.samples.back());
    }
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
      const double metres = in_si(distance_units(), mapping_.reference->unit);
      if (const auto x = value(columns_.x, row)) result.reference_x_m = metres * *x;
      if (const auto y = value(columns_.y, row)) result.reference_y_m = metres * *y;
      result.reference_theta_rad = value(columns_.theta_rad, row);
    }
    if (const auto gyro = value(columns_.gyro, row)) {
      result.gyro_z_rad_s = in_si(angular_units(), mapping_.gyro->unit) * *gyro;
    }
    if (const auto battery = value(columns_.battery, row)) {
      result.battery_v = in_si(voltage_units(), mapping_.battery->unit) * *battery;
    }
    return result;
  }

  static void add_counts(const std::array<Column, 2>& counts, std::size_t at, DriveSample& sample) {
    if (counts[0].empty() || !std::isfinite(counts[0][at])) return;
    const double right = counts[1].empty() ? 0.0 : counts[1][at];
    if (std::isfinite(right)) sample.ticks = WheelTicks{std::llround(counts[0][at]), std::llround(right)};
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
    return std::round(1e7 * median_step(counted.size() > 2  ? counted
                                        : placed.size() > 2 ? placed
                                                            : all)) /
           1e7;
  }

  const DriveColumns& columns_;
  const Column& times_s_;
  const Mapping& mapping_;
  const std::string& name_;
};

// Rows may be missing, or lie between the periods, but not by the hundred.
std::string period_contradiction(const DriveLog& log) {
  constexpr double most_off = 50.0;
  std::vector<double> t_s;
  for (const auto& sample : log.samples) t_s.push_back(sample.t_s);
  const double step_s = median_step(t_s);
  if (log.period_s <= most_off * step_s && step_s <= most_off * log.period_s) return {};
  return "rows are " + config::plain_number(step_s) + " s apart (median), but the period is said to be " +
         config::plain_number(log.period_s) +
         " s; correct it, or say the unit of the time: --set time.unit=ms";
}

std::string what_is_missing(const Mapping& mapping) {
  if (!mapping.command)
    return "no commands were found; say which columns hold them: --set command.left=COLUMN and "
           "command.right=COLUMN";
  if (!mapping.wheels && !mapping.reference)
    return "neither wheels nor a reference were found; say which columns hold them: --set wheels.left=COLUMN "
           "and wheels.right=COLUMN";
  if (!mapping.wheel_base_m && !is_one_wheel(mapping))
    return "the distance between the wheels is not known; give it: --set robot.wheel_base_m=0.235";
  if (mapping.wheels && mapping.wheels->kind == WheelKind::speed && mapping.wheels->unit.empty()) {
    return "the unit of the wheel speeds is not known; give it: --set wheels.unit=mm/s";
  }
  if (mapping.wheels && !wheel_scale(*mapping.wheels)) {
    return mapping.wheels->kind == WheelKind::counts
               ? "how far a wheel rolls for a count is not known; give it: --set "
                 "wheels.metres_per_count=0.0005"
               : "the radius of the wheels is not known; give it: --set wheels.wheel_radius_m=0.035";
  }
  if (mapping.command->kind == CommandKind::duty && !mapping.command->full_scale_m_s) {
    return "the speed that the largest duty leads to is not known; give it: --set command.full_scale_m_s=0.5";
  }
  return {};
}

}  // namespace

namespace {

// A log that writes counts only where they changed writes every column so.
bool is_written_on_change(const DriveColumns& columns) {
  const std::array<const Column*, 3> references{&columns.x, &columns.y, &columns.theta_rad};
  return std::ranges::any_of(columns.wheel, is_log_on_change) &&
         std::ranges::any_of(references, [](const Column* column) { return is_log_on_change(*column); });
}

DriveColumns filled(DriveColumns columns) {
  for (Column* column : {&columns.x, &columns.y, &columns.theta_rad, &columns.gyro, &columns.battery})
    fill_down(*column);
  return columns;
}

}  // namespace

TimeRepair repair_runs(const DriveColumns& columns) {
  TimeRepair all;
  std::vector<double> t_s = columns.t_s;
  if (const std::size_t spread = spread_coarse_stamps(t_s); spread > 0) {
    all.remarks.push_back(std::to_string(spread) +
                          " rows have the stamp of the row before: the clock is coarser than the rows, which "
                          "are taken to be even between its steps");
  }
  std::vector<std::size_t> starts = columns.run_starts;
  if (starts.empty()) starts.push_back(0);
  starts.push_back(t_s.size());
  for (std::size_t run = 0; run + 1 < starts.size(); ++run) {
    const std::size_t begin = starts[run];
    const RowQuestions ask{
        [&](std::size_t row) { return columns.place(begin + row); },
        [&](std::size_t a, std::size_t b) { return are_alike(columns, begin + a, begin + b); },
        [&](std::size_t row) { return is_at_rest(columns, begin + row); }};
    TimeRepair part = repair_time(std::span(t_s).subspan(begin, starts[run + 1] - begin), ask);
    std::ranges::copy(part.t_s, t_s.begin() + static_cast<std::ptrdiff_t>(begin));
    for (auto& rows : part.runs) {
      for (auto& row : rows) row += begin;
      all.runs.push_back(std::move(rows));
    }
    all.remarks.insert(all.remarks.end(), part.remarks.begin(), part.remarks.end());
  }
  all.t_s = std::move(t_s);
  return all;
}

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

tl::expected<Conversion, std::string> convert(const DriveColumns& columns, const Mapping& mapping,
                                              const std::string& name) {
  if (const auto missing = what_is_missing(mapping); !missing.empty())
    return tl::unexpected(name + ": " + missing);
  if (is_written_on_change(columns)) return convert(filled(columns), mapping, name);
  Conversion conversion;
  TimeRepair time = repair_runs(columns);
  conversion.remarks = columns.remarks;
  conversion.remarks.insert(conversion.remarks.end(), time.remarks.begin(), time.remarks.end());
  RunMaker maker(columns, time.t_s, mapping, name);
  for (const auto& rows : time.runs) {
    DriveLog log = maker.make(rows, conversion.remarks);
    if (log.samples.size() < 2) continue;
    if (const auto contradiction = period_contradiction(log); !contradiction.empty()) {
      return tl::unexpected(name + ": " + contradiction);
    }
    if (is_one_wheel(mapping)) log.other_metadata.emplace_back("one_wheel", "left");
    if (!mapping.robot.empty()) log.other_metadata.emplace_back("robot", mapping.robot);
    for (const auto& entry : mapping_entries(mapping)) {
      log.other_metadata.emplace_back("mapping." + entry.key, entry.value);
    }
    conversion.runs.push_back(std::move(log));
  }
  if (conversion.runs.empty()) return tl::unexpected(name + ": no run of two rows with a time and a command");
  return conversion;
}

}  // namespace wheelwright::import
