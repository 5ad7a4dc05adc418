#include "tools/wheelwright/import/inference/pixel_scale.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/column_names.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/units/reference_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

constexpr double min_agreement = 0.8;  // correlation of the ways of the reference with those of the robot
constexpr std::size_t min_way_windows = 10;

enum class WayBy { wheels, commands };

// What is known well enough to say how far the robot went in metres.
std::optional<WayBy> way_source(const DriveColumns& columns, const Mapping& mapping) {
  const bool has_wheels = mapping.wheels && mapping.wheels->right && !mapping.wheels->body_motion &&
                          mapping.wheels->kind != WheelKind::speed && !columns.wheel[1].empty();
  if (!mapping.wheel_base_m) return std::nullopt;
  if (has_wheels) return wheel_scale(*mapping.wheels) ? std::optional(WayBy::wheels) : std::nullopt;
  const bool has_speeds = mapping.command && !columns.command[0].empty() &&
                          (!mapping.command->is_duty() || mapping.command->full_scale_m_s.has_value());
  return has_speeds ? std::optional(WayBy::commands) : std::nullopt;
}

// How far the middle of the robot went up to each row, in metres, and how far it turned.
struct Ways {
  Column way;
  Column turn;

  explicit Ways(std::size_t rows) : way(rows, 0.0), turn(rows, 0.0) {}

  // Along the straight line from one row to another.
  double chord(std::size_t from, std::size_t to) const {
    const double half_turn = 0.5 * (turn[to] - turn[from]);
    const double share = std::abs(half_turn) > 1e-6 ? std::sin(half_turn) / half_turn : 1.0;
    return std::abs(share * (way[to] - way[from]));
  }
};

Ways ways_of_robot(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
                   WayBy source) {
  Ways ways(rows.size());
  const double base_m = *mapping.wheel_base_m;
  if (source == WayBy::wheels) {
    const double scale = *wheel_scale(*mapping.wheels);
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    const double left = mapping.wheels->left_reversed ? -scale : scale;
    const double right = mapping.wheels->right_reversed ? -scale : scale;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double left_m = left * travel.values[0][i];
      const double right_m = right * travel.values[1][i];
      ways.way[i] = 0.5 * (left_m + right_m);
      ways.turn[i] = (right_m - left_m) / base_m;
    }
    return ways;
  }
  const auto commands = wheel_commands(columns, rows, mapping);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double duration_s = columns.t_s[rows[i]] - columns.t_s[rows[i - 1]];
    const double left_m = duration_s * commands[0][i - 1];
    const double right_m = duration_s * commands[1][i - 1];
    const bool is_known = std::isfinite(left_m) && std::isfinite(right_m);
    ways.way[i] = ways.way[i - 1] + (is_known ? 0.5 * (left_m + right_m) : 0.0);
    ways.turn[i] = ways.turn[i - 1] + (is_known ? (right_m - left_m) / base_m : 0.0);
  }
  return ways;
}

// Over windows of a second.
struct WaySums {
  double products = 0.0;
  double robot_squares = 0.0;
  double place_squares = 0.0;
  double robot_way = 0.0;
  double place_way = 0.0;
  std::size_t windows = 0;

  void add_run(const DriveColumns& columns, std::span<const std::size_t> rows, const Ways& ways) {
    constexpr double window_s = 1.0;
    std::size_t from = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t row = rows[i];
      if (!std::isfinite(columns.x[row]) || !std::isfinite(columns.y[row]) || !std::isfinite(ways.way[i]))
        continue;
      if (from < rows.size()) {
        const std::size_t start = rows[from];
        if (columns.t_s[row] - columns.t_s[start] < window_s) continue;
        add(ways.chord(from, i),
            std::hypot(columns.x[row] - columns.x[start], columns.y[row] - columns.y[start]));
      }
      from = i;
    }
  }

  void add(double robot, double place) {
    products += robot * place;
    robot_squares += robot * robot;
    place_squares += place * place;
    ++windows;
    constexpr double min_way_m = 0.05;  // beside which noise is small
    if (robot < min_way_m) return;
    robot_way += robot;
    place_way += place;
  }

  // Of places for each metre of the robot; nothing where the two do not go together. All of the way of
  // commands is compared, since the robot comes behind them.
  std::optional<double> slope(WayBy source) const {
    const double way = source == WayBy::commands ? robot_way : robot_squares;
    if (windows < min_way_windows || !(way > 0.0) || !(place_squares > 0.0)) return std::nullopt;
    if (products / std::sqrt(robot_squares * place_squares) < min_agreement) return std::nullopt;
    return source == WayBy::commands ? place_way / robot_way : products / robot_squares;
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
