#include "tools/wheelwright/import/conversion/run_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/wheelwright/import/conversion/counter_resets.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"

namespace wheelwright::import {
namespace {

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

// An angle within one turn, of radians or degrees, which starts again at each.
bool goes_round(const Column& angles) {
  constexpr double turns[] = {2.0 * std::numbers::pi, 360.0};
  const double size = range_of(angles).size();
  return std::ranges::any_of(turns, [size](double turn) { return size > 0.9 * turn && size < 1.01 * turn; });
}

std::vector<std::size_t> resets_of(const DriveColumns& columns, const WheelMapping& wheels,
                                   const RunRows& rows) {
  std::vector<std::size_t> resets;
  if (wheels.bits) return resets;  // it wraps
  for (const Column& wheel : columns.wheel) {
    if (wheel.empty() || (wheels.kind != WheelKind::counts && goes_round(wheel))) continue;
    Column travel;
    travel.reserve(rows.size());
    for (const std::size_t row : rows) travel.push_back(wheel[row]);
    const auto of_side = counter_resets(travel);
    resets.insert(resets.end(), of_side.begin(), of_side.end());
  }
  std::ranges::sort(resets);
  resets.erase(std::unique(resets.begin(), resets.end()), resets.end());
  return resets;
}

void split_at_resets(const DriveColumns& columns, const WheelMapping& wheels, TimeRepair& time) {
  std::vector<RunRows> runs;
  for (const auto& rows : time.runs) {
    auto ends = resets_of(columns, wheels, rows);
    for (const std::size_t reset : ends) {
      time.remarks.push_back(columns.place(rows[reset]) +
                             ": the counts start again from zero; a new run begins");
    }
    ends.push_back(rows.size());
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      if (end > begin + 1)
        runs.emplace_back(rows.begin() + static_cast<std::ptrdiff_t>(begin),
                          rows.begin() + static_cast<std::ptrdiff_t>(end));
      begin = end;
    }
  }
  time.runs = std::move(runs);
}

}  // namespace

TimeRepair repair_runs(const DriveColumns& columns, const Mapping& mapping) {
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
    all.set_back += part.set_back;
    all.remarks.insert(all.remarks.end(), part.remarks.begin(), part.remarks.end());
  }
  all.t_s = std::move(t_s);
  if (mapping.wheels && mapping.wheels->kind != WheelKind::speed && !mapping.wheels->per_row)
    split_at_resets(columns, *mapping.wheels, all);
  return all;
}

}  // namespace wheelwright::import
