#include "tools/wheelwright/import/inference/pixel_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/inference/robot_ways.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/units/reference_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

struct WaySums {
  Agreement agreement;
  double robot_way = 0.0;
  double place_way = 0.0;

  void add_run(const DriveColumns& columns, std::span<const std::size_t> rows, const Ways& ways) {
    std::vector<char> is_known;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool stands = std::isfinite(columns.x[rows[i]]) && std::isfinite(columns.y[rows[i]]);
      is_known.push_back(stands && std::isfinite(ways.way[i]) ? 1 : 0);
    }
    for (const auto& [from, to] : windows_of(columns, rows, is_known)) {
      add(ways.chord(from, to), std::hypot(columns.x[rows[to]] - columns.x[rows[from]],
                                           columns.y[rows[to]] - columns.y[rows[from]]));
    }
  }

  void add(double robot, double place) {
    agreement.add(robot, place);
    constexpr double min_way_m = 0.05;  // beside which noise is small
    if (robot < min_way_m) return;
    robot_way += robot;
    place_way += place;
  }

  // Of places for each metre of the robot; nothing where the two do not go together. All of the way of
  // commands is compared, since the robot comes behind them.
  std::optional<double> slope(WayBy source) const {
    const bool by_commands = source == WayBy::commands;
    if (!agreement.holds() || (by_commands && !(robot_way > 0.0))) return std::nullopt;
    return by_commands ? place_way / robot_way : agreement.slope();
  }
};

std::optional<double> places_per_metre(const DriveColumns& columns, const Mapping& mapping, WayBy source) {
  WaySums sums;
  for (const auto& rows : repair_runs(columns, mapping).runs)
    sums.add_run(columns, rows, ways_of_robot(columns, rows, mapping, source));
  return sums.slope(source);
}

// Of places that no one gives a unit: whether no unit of length explains how far they go beside the robot.
// The scale of wheels that was found by these places says nothing, nor do commands that may be in other
// units.
bool are_in_no_unit(const DriveColumns& columns, const Mapping& mapping, WayBy source, double slope) {
  constexpr double far = 3.0;
  if (source == WayBy::wheels)
    return mapping.wheels->scale_from != from_reference && (slope > far || slope < 1.0 / far);
  return slope > far && !mapping.command->is_duty() && largest(columns.command[0]) <= fastest_m_s;
}

// As far as a robot that does about what it is told
// goes in one of these units.
bool take_small_unit(double places_per_commanded_metre, ReferenceMapping& reference,
                     std::vector<std::string>& findings) {
  for (const char* unit : {"mm", "cm"}) {
    if (!is_near(places_per_commanded_metre, 1.0 / in_si(distance_units(), unit))) continue;
    reference.unit = unit;
    findings.push_back("places are in " + reference.unit + ": they go " +
                       plain_number(rounded_gain(places_per_commanded_metre)) +
                       " times as far as commanded in metres");
    return true;
  }
  return false;
}

// In an image no place lies left of its origin, or above it.
double smallest(const Column& column) {
  double value = std::numeric_limits<double>::infinity();
  for (const double one : column) value = std::isfinite(one) ? std::min(value, one) : value;
  return value;
}

// By the unit of the column, or as messages are.
bool states_metres(std::span<const Recording> recordings, const ChannelName& x) {
  const FoundChannel found = find_channel(recordings, x);
  return found.channel != nullptr &&
         (!found.stream->type.empty() ||
          find_unit(distance_units(), meaning_of(*found.stream, *found.channel).unit));
}

}  // namespace

void infer_pixel_scale(std::span<const Recording> recordings, const DriveColumns& columns,
                       const GivenMapping& given, Mapping& mapping, std::vector<std::string>& findings,
                       std::vector<std::string>& doubts) {
  if (!mapping.reference || columns.x.empty() || columns.y.empty()) return;
  ReferenceMapping& reference = *mapping.reference;
  const bool are_pixels = reference.unit == pixel_unit && !reference.metres_per_pixel;
  const bool may_be_pixels = reference.unit == "m" && !given.says("reference.unit");
  const auto source = way_source(columns, mapping);
  if ((!are_pixels && !may_be_pixels) || !source) return;
  const auto slope = places_per_metre(columns, mapping, *source);
  if (!slope || (!are_pixels && !are_in_no_unit(columns, mapping, *source, *slope))) return;
  const std::string robot = *source == WayBy::wheels ? "the wheels" : "commanded";
  const std::string times = plain_number(rounded_gain(*slope)) + " times as far as " + robot + " in metres";
  if (!are_pixels && states_metres(recordings, *reference.x)) {
    doubts.push_back("x and y, which are said to be in metres, go " + times +
                     ": check the scale of the wheels (wheels.metres_per_count) and reference.unit");
    return;
  }
  const bool in_image = smallest(columns.x) >= 0.0 && smallest(columns.y) >= 0.0;
  if (!are_pixels && !in_image && *source == WayBy::commands && take_small_unit(*slope, reference, findings))
    return;
  reference.unit = pixel_unit;
  reference.metres_per_pixel = rounded_gain(1.0 / *slope);
  reference.scale_from_robot = true;
  const std::string size = plain_number(*reference.metres_per_pixel) + " m";
  if (are_pixels) {
    findings.push_back("a pixel is " + size + " on the floor: x and y go " + times +
                       "; --set reference.metres_per_pixel if you know it");
  } else {
    doubts.push_back("x and y are in no unit of length: they go " + times + ", and are taken for pixels of " +
                     size + "; say it otherwise: --set reference.unit, or --set wheels.metres_per_count");
  }
}

}  // namespace wheelwright::import
