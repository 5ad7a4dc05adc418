#include "tools/wheelwright/import/conversion/repair_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/counter_resets.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"

namespace wheelwright::import {
namespace {

constexpr double longest_period_s = 5.0;
constexpr double restart_rows = 3.0;
constexpr double fastest_m_s = 5.0;

// Counts of one wheel, not-a-number where a row has none.
std::vector<double> counts_of(const DriveLog& run, std::int64_t WheelTicks::*side) {
  std::vector<double> counts;
  for (const auto& sample : run.samples) {
    counts.push_back(sample.ticks ? static_cast<double>((*sample.ticks).*side)
                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return counts;
}

bool pauses(const DriveLog& run) {
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    if (run.samples[i].t_s - run.samples[i - 1].t_s >
        std::max(longest_pause_s, longest_pause_steps * run.period_s))
      return true;
  }
  return false;
}

bool has_bunched_stamps(const DriveLog& run, const std::vector<double>& counts) {
  std::vector<double> t_s;
  for (const auto& sample : run.samples) t_s.push_back(sample.t_s);
  return even_stamps(t_s, counts).has_value();
}

// Of most rows on which anything is commanded: single ones are garbage of a serial line.
bool commands_are_no_speeds(const DriveLog& run) {
  std::size_t driven = 0;
  std::size_t too_fast = 0;
  for (const auto& sample : run.samples) {
    const double size = std::max(std::abs(sample.command_m_s.left), std::abs(sample.command_m_s.right));
    if (size > 0.0) ++driven;
    if (size > fastest_m_s) ++too_fast;
  }
  return 2 * too_fast > driven;
}

// Its time begins within the run before, not where that began.
bool goes_on(const DriveLog& before, const DriveLog& run) {
  return run.samples.front().t_s > before.samples.front().t_s + restart_rows * before.period_s;
}

// How far the reference turns for a radian by the counts, over windows in which the wheels go some way; 0
// where nothing tells.
double turn_slope(const DriveLog& run) {
  constexpr double window_m = 0.1;
  double products = 0.0;
  double squares = 0.0;
  const DriveSample* from = nullptr;
  for (const auto& sample : run.samples) {
    if (!sample.ticks || !sample.reference_theta_rad) continue;
    if (from == nullptr) from = &sample;
    const double left =
        run.metres_per_tick->left * static_cast<double>(sample.ticks->left - from->ticks->left);
    const double right =
        run.metres_per_tick->right * static_cast<double>(sample.ticks->right - from->ticks->right);
    if (std::abs(left) + std::abs(right) < window_m) continue;
    const double turn = (right - left) / run.wheel_base_m;
    const double seen = *sample.reference_theta_rad - *from->reference_theta_rad;
    if (std::abs(turn) < 2.0 && std::abs(seen) < 150.0) {
      products += turn * seen;
      squares += turn * turn;
    }
    from = &sample;
  }
  return squares > 0.0 ? products / squares : 0.0;
}

bool has_degrees(const DriveLog& run) {
  constexpr double degrees = 57.3;
  const double slope = turn_slope(run);
  return slope > degrees / 1.35 && slope < degrees * 1.35;
}

std::optional<std::string> find_repair(const DriveLog& run) {
  if (run.period_s > longest_period_s) return "a period of seconds";
  if (pauses(run)) return "a long pause";
  if (commands_are_no_speeds(run)) return "commands that are no speeds";
  if (!run.has_ticks()) return std::nullopt;
  if (has_degrees(run)) return "headings in degrees";
  for (const auto side : {&WheelTicks::left, &WheelTicks::right}) {
    const auto counts = counts_of(run, side);
    if (wrapped_bits(counts)) return "a counter that wraps";
    if (is_log_on_change(counts)) return "counts that are written only where they changed";
    if (!counter_resets(counts).empty()) return "counts that start again from zero";
  }
  if (has_bunched_stamps(run, counts_of(run, &WheelTicks::left))) return "stamps in bunches";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> find_repair(std::span<const DriveLog> runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0 && goes_on(runs[i - 1], runs[i])) return "rows out of order";
    if (auto repair = find_repair(runs[i])) return repair;
  }
  return std::nullopt;
}

bool is_drive_log(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // a pipe might never answer
  constexpr std::string_view mark = "# wheelwright_drive_log:";
  std::array<char, mark.size()> head{};
  std::ifstream(path).read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == mark;
}

}  // namespace wheelwright::import
