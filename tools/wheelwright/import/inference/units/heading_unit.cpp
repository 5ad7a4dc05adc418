#include "tools/wheelwright/import/inference/units/heading_unit.hpp"

#include <cmath>
#include <numbers>
#include <span>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/inference/robot_ways.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {
namespace {

// Turns over windows of a second, whatever their sense. A heading that wraps at some angle leaves few windows
// out.
struct TurnSums {
  double products = 0.0;
  double commanded_squares = 0.0;
  double seen_squares = 0.0;
  std::size_t windows = 0;

  void add_run(const DriveColumns& columns, std::span<const std::size_t> rows, const Column& turn) {
    constexpr double window_s = 1.0;
    std::size_t from = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!std::isfinite(columns.theta_rad[rows[i]]) || !std::isfinite(turn[i])) continue;
      if (from < rows.size()) {
        if (columns.t_s[rows[i]] - columns.t_s[rows[from]] < window_s) continue;
        add(std::abs(turn[i] - turn[from]),
            std::abs(columns.theta_rad[rows[i]] - columns.theta_rad[rows[from]]));
      }
      from = i;
    }
  }

  void add(double commanded, double seen) {
    constexpr double half_turn_in_degrees = 180.0;
    if (seen > half_turn_in_degrees) return;
    products += commanded * seen;
    commanded_squares += commanded * commanded;
    seen_squares += seen * seen;
    ++windows;
  }

  double slope() const { return products / commanded_squares; }
  double correlation() const { return products / std::sqrt(commanded_squares * seen_squares); }
};

}  // namespace

bool infer_heading_unit(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings) {
  constexpr std::size_t min_windows = 10;
  constexpr double min_correlation = 0.8;
  if (!mapping.reference || !mapping.reference->theta || columns.theta_rad.empty() ||
      mapping.reference->angle_unit != "rad" || given.says("reference.angle_unit") ||
      way_source(columns, mapping) != WayBy::commands)
    return false;
  TurnSums sums;
  for (const auto& rows : repair_runs(columns, mapping).runs)
    sums.add_run(columns, rows, ways_of_robot(columns, rows, mapping, WayBy::commands).turn);
  if (sums.windows < min_windows || !(sums.correlation() > min_correlation) ||
      !is_near(sums.slope(), 180.0 / std::numbers::pi))
    return false;
  mapping.reference->angle_unit = "deg";
  findings.push_back("headings are in degrees: they turn " + config::fixed_number(sums.slope(), 1) +
                     " times as far as commanded in radians");
  return true;
}

}  // namespace wheelwright::import
