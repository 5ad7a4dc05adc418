#include "tools/wheelwright/import/inference/response_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {
namespace {

constexpr double burst_part = 0.2;  // of the median step: a shorter one is of a burst

// Between rows that have a value.
double median_step_of(const std::vector<double>& t_s, const Column& values) {
  std::vector<double> steps;
  double last_s = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (std::isfinite(last_s)) steps.push_back(t_s[i] - last_s);
    last_s = t_s[i];
  }
  if (steps.empty()) return 0.0;
  return median(std::move(steps));
}

// Measured speed per row from travel or speeds; commands as they were in force before each row.
void add_run(const DriveColumns& columns, const Column& times_s, const Mapping& mapping, const RunRows& rows,
             std::array<ResponseRows, 2>& result) {
  const WheelTravel travel = wheel_travel(columns, rows, mapping);
  const bool is_speed = mapping.wheels->kind == WheelKind::speed;
  const bool is_pair = !travel.values[1].empty();
  const bool as_body = mapping.command->is_of_body() && !mapping.wheels->body_motion && is_pair;
  std::array<double, 2> command{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};
  std::array<double, 2> in_force{std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::quiet_NaN()};
  std::array<double, 2> last{std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::quiet_NaN()};
  double last_s = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> t_s;
  for (const std::size_t row : rows) t_s.push_back(times_s[row]);
  if (!is_speed) {
    if (const auto even = even_stamps(t_s, travel.values[0])) t_s = even->t_s;
  }
  const double shortest_s = burst_part * median_step_of(t_s, travel.values[0]);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::array<double, 2> value{travel.values[0][i],
                                      is_pair ? travel.values[1][i] : travel.values[0][i]};
    if (std::isfinite(value[0]) && std::isfinite(value[1])) {
      const double duration_s = t_s[i] - last_s;
      std::array<double, 2> speed{};
      // Rows that were handled in one go say nothing of a speed.
      const bool is_burst = !is_speed && duration_s < shortest_s;
      for (std::size_t k = 0; k < 2; ++k)
        speed[k] = is_speed   ? value[k]
                   : is_burst ? std::numeric_limits<double>::quiet_NaN()
                              : (value[k] - last[k]) / duration_s;
      if (as_body) {
        const WheelMapping& wheels = *mapping.wheels;
        const double left = wheels.left_reversed ? -speed[0] : speed[0];
        const double right = wheels.right_reversed ? -speed[1] : speed[1];
        speed = {0.5 * (left + right), right - left};
      }
      for (std::size_t k = 0; k < 2; ++k) {
        result[k].speed.push_back(speed[k]);
        result[k].command.push_back(in_force[k]);
      }
      last = value;
      last_s = t_s[i];
      in_force = command;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const Column& column = columns.command[columns.command[k].empty() ? 0 : k];
      if (std::isfinite(column[rows[i]])) command[k] = column[rows[i]];
    }
    if (i == 0) in_force = command;
  }
  for (auto& side : result) side.run_ends.push_back(side.speed.size());
}

}  // namespace

std::array<ResponseRows, 2> response_rows(const DriveColumns& columns, const Mapping& mapping) {
  std::array<ResponseRows, 2> result;
  const TimeRepair time = repair_runs(columns, mapping);
  for (const auto& rows : time.runs) add_run(columns, time.t_s, mapping, rows, result);
  return result;
}

}  // namespace wheelwright::import
