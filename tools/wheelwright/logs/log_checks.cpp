#include "tools/wheelwright/logs/log_checks.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/text_format.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/log/near_periods.hpp"
#include "model/log/run_periods.hpp"
#include "model/prediction/segments.hpp"
#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {
namespace {

using config::plain_number;

constexpr double roomba_limit_m_s = 0.5;  // of Drive Direct, Open Interface
constexpr double any_robot_limit_m_s = 5.0;

constexpr double over_limit = 4.0;  // readings that come late or early make a wheel look faster
constexpr double always_possible_m = 0.01;

bool is_roomba(std::string_view robot) {
  const std::string name = config::lower_case(robot);
  return name.find("roomba") != std::string::npos || name.find("create") != std::string::npos;
}

// Calibrations of one robot scatter by less, other robots differ by more.
constexpr double max_apart_scales = 0.05;
constexpr double max_apart_bases = 0.02;

std::string line_of(const DriveLog& log, std::size_t row) {
  return log.name + ":" + std::to_string(log.first_line + row);
}

bool differ(double one, double other, double share) {
  return std::abs(one - other) > share * other;
}

void check_counts(const DriveLog& run, bool others_have_some) {
  if (run.has_ticks()) return;
  const bool any =
      std::ranges::any_of(run.samples, [](const auto& sample) { return sample.ticks.has_value(); });
  const std::string where = line_of(run, 0) + ": ";
  throw UsageError(
      where +
      (any ? "no encoder counts on the first row; delete the rows above the first that has them"
       : others_have_some
           ? "no encoder counts, but other runs have some; fit runs with counts and runs with poses alone "
             "apart"
           : "neither encoder counts (columns ticks_left and ticks_right) nor reference poses (ref_x, ref_y, "
             "ref_theta); a fit needs one of them"));
}

void check_distance_of_rows(const DriveLog& run) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < run.samples.size(); ++k) {
    steps.push_back(run.samples[k].t_s - run.samples[k - 1].t_s);
  }
  if (steps.empty()) return;
  const double step_s = median(std::move(steps));
  if (step_s <= longest_step_periods * run.period_s) return;
  throw UsageError(line_of(run, 0) + ": its rows are " + config::fixed_number(step_s, 6) +
                   " s apart (median), but '# period_s' says " + plain_number(run.period_s) +
                   " s; correct it, or log every period");
}

// What of a run is not that of the first, up to "... that".
std::optional<std::string> find_difference(const DriveLog& run, const DriveLog& first) {
  const auto numbers = [](double one, double other, const std::string& unit) {
    return plain_number(one) + " " + unit + ", but " + plain_number(other) + " " + unit + " is that";
  };
  if (robot_name(run) != robot_name(first) && robot_name(run) != "unknown" &&
      robot_name(first) != "unknown") {
    return "robot is '" + robot_name(run) + "', but '" + robot_name(first) + "' is that";
  }
  if (std::abs(run.wheel_base_m - first.wheel_base_m) > 1e-9) {
    return "wheel base is " + numbers(run.wheel_base_m, first.wheel_base_m, "m");
  }
  if (!run.metres_per_tick || !first.metres_per_tick) return std::nullopt;
  const WheelPair& scale = *run.metres_per_tick;
  const WheelPair& first_scale = *first.metres_per_tick;
  if (differ(scale.left, first_scale.left, max_apart_scales)) {
    return "metres_per_tick_left is " + numbers(scale.left, first_scale.left, "m");
  }
  if (differ(scale.right, first_scale.right, max_apart_scales)) {
    return "metres_per_tick_right is " + numbers(scale.right, first_scale.right, "m");
  }
  return std::nullopt;
}

double limit_of_commands_m_s(const DriveLog& log, std::optional<double> limit_m_s) {
  return limit_m_s.value_or(is_roomba(robot_name(log)) ? roomba_limit_m_s : any_robot_limit_m_s);
}

std::string describe_jump(const std::string& column, std::int64_t ticks, double duration_s) {
  const bool is_wrap = std::abs(std::abs(ticks) - 65536) < 2000;
  return column + " jumps by " + std::to_string(ticks) + " in " + config::fixed_number(duration_s, 3) +
         " s, which no wheel does; " +
         (is_wrap ? "unwrap the 16-bit counter" : "delete the row if it is garbage");
}

}  // namespace

void check_output(const config::OutputFile& output, const std::vector<std::string>& inputs) {
  if (output.path.empty()) return;
  if (const auto problem = config::check_outputs({&output, 1}, {inputs.begin(), inputs.end()})) {
    throw UsageError(*problem);
  }
}

std::string robot_name(const DriveLog& log) {
  for (const auto& [key, value] : log.other_metadata) {
    if (key == "robot") return value;
  }
  return "unknown";
}

std::optional<std::string> find_impossible_command(const DriveLog& log, std::optional<double> limit_m_s) {
  const double limit = limit_of_commands_m_s(log, limit_m_s);
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const WheelPair& command = log.samples[k].command_m_s;
    const double largest = std::max(std::abs(command.left), std::abs(command.right));
    if (largest <= limit) continue;
    const std::string robot = is_roomba(robot_name(log)) && !limit_m_s ? "a Roomba or Create takes"
                                                                       : "the robot is assumed to take";
    return line_of(log, k) + ": a command of " + plain_number(largest) + " m/s, but " + robot + " at most " +
           plain_number(limit) + " m/s; delete the row if it is garbage";
  }
  return std::nullopt;
}

std::optional<std::string> find_impossible_counts(const DriveLog& log, std::optional<double> limit_m_s) {
  if (!log.metres_per_tick) return std::nullopt;
  const double fastest = over_limit * limit_of_commands_m_s(log, limit_m_s);
  const DriveSample* before = nullptr;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const DriveSample& sample = log.samples[k];
    if (!sample.ticks) continue;
    const DriveSample* last = std::exchange(before, &sample);
    if (last == nullptr) continue;
    const double duration_s = sample.t_s - last->t_s;
    const double possible_m = fastest * duration_s + always_possible_m;
    const std::int64_t left = sample.ticks->left - last->ticks->left;
    const std::int64_t right = sample.ticks->right - last->ticks->right;
    if (std::abs(static_cast<double>(left)) * log.metres_per_tick->left > possible_m) {
      return line_of(log, k) + ": " + describe_jump("ticks_left", left, duration_s);
    }
    if (std::abs(static_cast<double>(right)) * log.metres_per_tick->right > possible_m) {
      return line_of(log, k) + ": " + describe_jump("ticks_right", right, duration_s);
    }
  }
  return std::nullopt;
}

void check_runs_of_one_robot(const std::vector<DriveLog>& runs, bool by_poses) {
  const bool any_counts = std::ranges::any_of(runs, &DriveLog::has_ticks);
  for (const auto& run : runs) {
    if (!by_poses) check_counts(run, any_counts);
    check_distance_of_rows(run);
    if (const auto difference = find_difference(run, runs.front())) {
      throw UsageError(run.name + ": its " + *difference + " of " + runs.front().name +
                       "; fit runs of one robot together");
    }
  }
  if (const auto far = find_far_period(runs)) throw UsageError(*far);
}

void check_log_for_model(const DriveLog& log, const LinearModel& model, std::ostream& err) {
  if (!are_near_periods(log.period_s, model.period_s)) {
    throw UsageError(log.name + ": " + different_periods(log.period_s, "the model", model.period_s) +
                     "; fit a model to runs of this period");
  }
  if (const auto impossible = find_impossible_command(log, std::nullopt)) {
    err << "wheelwright: warning: " << *impossible << "\n";
  }
  if (const auto impossible = find_impossible_counts(log, std::nullopt)) {
    err << "wheelwright: warning: " << *impossible << "\n";
  }
  // One that was fitted to poses has a wheel base of its own.
  if (differ(log.wheel_base_m, model.wheel_base_m, max_apart_bases)) {
    err << "wheelwright: warning: " << log.name << ": its wheel base is " << plain_number(log.wheel_base_m)
        << " m, but that of the model is " << config::fixed_number(model.wheel_base_m, 4)
        << " m; is it another robot, or was the model fitted to poses, by which turns have a wheel base of "
           "their own?\n";
  }
  for (const auto& hole : describe_holes(log)) {
    err << "wheelwright: warning: " << hole << "; what was commanded there is not known\n";
  }
}

std::vector<std::string> describe_holes(const DriveLog& log) {
  constexpr std::size_t max_told = 5;
  const auto holes = find_holes(log);
  std::vector<std::string> lines;
  for (const auto& hole : holes) {
    const std::string where = line_of(log, hole.row);
    if (lines.size() == max_told) {
      lines.push_back(where + ": and " + std::to_string(holes.size() - max_told) +
                      " more holes from here on");
      break;
    }
    lines.push_back(where + ": no rows for " + config::fixed_number(hole.duration_s, 3) + " s");
  }
  return lines;
}

std::vector<std::string> describe_contradictions(const std::vector<DriveLog>& runs) {
  constexpr std::size_t max_lines = 10;
  std::vector<std::string> lines;
  std::size_t more = 0;
  for (const DriveLog& run : runs) {
    for (const gap::DataFault& fault : gap::gate(run).faults) {
      if (fault.happened) continue;
      if (lines.size() == max_lines) {
        ++more;
      } else {
        lines.push_back(fault.log + ":" + std::to_string(fault.row) + ": " + fault.what);
      }
    }
  }
  if (more > 0) lines.push_back("and " + std::to_string(more) + " more like these");
  return lines;
}

}  // namespace wheelwright::tools
