#include "tools/wheelwright/import/inference/response_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr double burst_part = 0.2;  // of the median step: a shorter one is of a burst

// Between rows that have a value.
double median_step_of(const std::vector<double>& t_s, const Column& values) {
  std::vector<double> steps;
  double last_s = nothing;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (std::isfinite(last_s)) steps.push_back(t_s[i] - last_s);
    last_s = t_s[i];
  }
  if (steps.empty()) return 0.0;
  return median(std::move(steps));
}

constexpr std::array nothings{nothing, nothing};

// Rows that are put together, so that the thirty rows of a response are 1.5 s at any rate: by then all but
// 0.7 % of a lag of 0.3 s is over. Longer rows would mix commands that show where the wheels rest.
constexpr double shortest_row_s = 0.05;

// What has come since the row that was given last.
struct Group {
  std::size_t rows = 0;
  double duration_s = 0.0;
  std::array<double, 2> commanded{};  // integral over the time
  std::array<double, 2> measured{};   // of speeds that were measured, the same
};

// A short run is too short for groups.
std::size_t rows_of_group(double step_s, std::size_t rows) {
  constexpr std::size_t enough_groups = 200;
  if (!(step_s > 0.0)) return 1;
  const auto wanted = static_cast<std::size_t>(std::max(1L, std::lround(shortest_row_s / step_s)));
  return std::clamp<std::size_t>(rows / enough_groups, 1, wanted);
}

class RunResponse {
 public:
  RunResponse(const DriveColumns& columns, const Mapping& mapping, std::array<ResponseRows, 2>& result)
      : columns_(columns),
        mapping_(mapping),
        is_speed_(mapping.wheels->kind == WheelKind::speed),
        result_(result) {}

  void add(const RunRows& rows, const Column& times_s) {
    const WheelTravel travel = wheel_travel(columns_, rows, mapping_);
    is_pair_ = !travel.values[1].empty();
    std::vector<double> t_s;
    for (const std::size_t row : rows) t_s.push_back(times_s[row]);
    if (!is_speed_) {
      if (const auto even = even_stamps(t_s, travel.values[0])) t_s = even->t_s;
    }
    const double step_s = median_step_of(t_s, travel.values[0]);
    shortest_s_ = burst_part * step_s;
    group_rows_ = rows_of_group(step_s, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::array<double, 2> value{travel.values[0][i],
                                        is_pair_ ? travel.values[1][i] : travel.values[0][i]};
      if (std::isfinite(value[0]) && std::isfinite(value[1])) take(value, t_s[i]);
      take_command(rows[i]);
      if (i == 0) in_force_ = command_;
    }
    for (auto& side : result_) side.run_ends.push_back(side.speed.size());
  }

 private:
  void take(const std::array<double, 2>& value, double t_s) {
    const double duration_s = t_s - last_s_;
    last_s_ = t_s;
    ++group_.rows;
    group_.duration_s += duration_s;
    for (std::size_t k = 0; k < 2; ++k) {
      group_.commanded[k] += in_force_[k] * duration_s;
      group_.measured[k] += value[k] * duration_s;
    }
    in_force_ = command_;
    if (group_.rows < group_rows_ && std::isfinite(duration_s)) return;
    give(value);
    group_ = {};
    last_ = value;
  }

  void give(const std::array<double, 2>& value) {
    // Rows that were handled in one go say nothing of a speed.
    const bool is_burst = !is_speed_ && group_.duration_s < shortest_s_;
    std::array<double, 2> speed = nothings;
    for (std::size_t k = 0; k < 2 && !is_burst; ++k)
      speed[k] = (is_speed_ ? group_.measured[k] : value[k] - last_[k]) / group_.duration_s;
    if (mapping_.command->is_of_body() && is_pair_) {
      const double left = mapping_.wheels->left_reversed ? -speed[0] : speed[0];
      const double right = mapping_.wheels->right_reversed ? -speed[1] : speed[1];
      speed = {0.5 * (left + right), right - left};
    }
    for (std::size_t k = 0; k < 2; ++k) {
      result_[k].speed.push_back(speed[k]);
      result_[k].command.push_back(group_.commanded[k] / group_.duration_s);
    }
  }

  void take_command(std::size_t row) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Column& column = columns_.command[columns_.command[k].empty() ? 0 : k];
      if (std::isfinite(column[row])) command_[k] = column[row];
    }
  }

  const DriveColumns& columns_;
  const Mapping& mapping_;
  bool is_speed_;
  std::array<ResponseRows, 2>& result_;
  bool is_pair_ = false;
  double shortest_s_ = 0.0;
  std::size_t group_rows_ = 1;
  std::array<double, 2> command_ = nothings;
  std::array<double, 2> in_force_ = nothings;
  std::array<double, 2> last_ = nothings;
  double last_s_ = nothing;
  Group group_;
};

}  // namespace

std::array<ResponseRows, 2> response_rows(const DriveColumns& columns, const Mapping& mapping) {
  std::array<ResponseRows, 2> result;
  const TimeRepair time = repair_runs(columns, mapping);
  for (const auto& rows : time.runs) RunResponse(columns, mapping, result).add(rows, time.t_s);
  return result;
}

}  // namespace wheelwright::import
