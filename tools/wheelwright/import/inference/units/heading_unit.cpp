#include "tools/wheelwright/import/inference/units/heading_unit.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <tuple>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/inference/robot_ways.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {
namespace {

// Turns, whatever their sense. A heading that wraps at some angle leaves few windows out.
void add_turns(const DriveColumns& columns, std::span<const std::size_t> rows, const Column& turn,
               Agreement& agreement) {
  constexpr double half_turn_in_degrees = 180.0;
  std::vector<char> is_known;
  for (std::size_t i = 0; i < rows.size(); ++i)
    is_known.push_back(std::isfinite(columns.theta_rad[rows[i]]) && std::isfinite(turn[i]) ? 1 : 0);
  for (const auto& [from, to] : windows_of(columns, rows, is_known)) {
    const double seen = std::abs(columns.theta_rad[rows[to]] - columns.theta_rad[rows[from]]);
    if (seen <= half_turn_in_degrees) agreement.add(std::abs(turn[to] - turn[from]), seen);
  }
}

// Headings that start again behind a whole turn, and go on evenly elsewhere.
bool wrap_at(double turn, const Column& headings) {
  const double wrap = 5.0 / 6.0 * turn;
  const double even = 1.0 / 6.0 * turn;
  std::size_t wraps = 0;
  double last = nothing;
  for (const double heading : headings) {
    if (!std::isfinite(heading)) continue;
    const double step = std::abs(heading - last);
    if (step > turn || (step > even && step < wrap)) return false;
    if (step >= wrap) ++wraps;
    last = heading;
  }
  return wraps > 0;
}

}  // namespace

bool infer_heading_unit(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings) {
  if (!mapping.reference || !mapping.reference->theta || columns.theta_rad.empty() ||
      mapping.reference->angle_unit != "rad" || given.says("reference.angle_unit"))
    return false;
  for (const auto& [unit, words, turn] : {std::tuple{"deg", "degrees", 360.0},
                                          {"0.1deg", "tenths of a degree", 3600.0},
                                          {"0.01deg", "hundredths of a degree", 36000.0}}) {
    if (!wrap_at(turn, columns.theta_rad)) continue;
    mapping.reference->angle_unit = unit;
    findings.push_back(std::string("headings are in ") + words + ": they start again behind " +
                       config::plain_number(turn));
    return true;
  }
  if (way_source(columns, mapping) != WayBy::commands) return false;
  Agreement turns;
  for (const auto& rows : repair_runs(columns, mapping).runs)
    add_turns(columns, rows, ways_of_robot(columns, rows, mapping, WayBy::commands).turn, turns);
  if (!turns.holds() || !is_near(turns.slope(), 180.0 / std::numbers::pi)) return false;
  mapping.reference->angle_unit = "deg";
  findings.push_back("headings are in degrees: they turn " + config::fixed_number(turns.slope(), 1) +
                     " times as far as commanded in radians");
  return true;
}

}  // namespace wheelwright::import
