#include "tools/wheelwright/import/inference/reference_frame.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/wheel_directions.hpp"

namespace wheelwright::import {
namespace {

using std::numbers::pi;

constexpr double frame_window_s = 0.5;

// What the reference and the wheels did between two poses.
struct Window {
  std::complex<double> moved;
  double heading = 0.0;  // half-way, in the unit of the column taken for radians
  double turned = 0.0;   // the same
  double turn_of_wheels = 0.0;
};

double wrapped(double angle, double turn) {
  return angle - turn * std::round(angle / turn);
}

// Zero of a reference that tells headings alone.
std::complex<double> place_of(const DriveColumns& columns, std::size_t row) {
  return columns.x.empty() ? 0.0 : std::complex<double>(columns.x[row], columns.y[row]);
}

std::vector<Window> windows_of(const DriveColumns& columns, const Mapping& mapping,
                               const std::array<double, 2>& directions, double turn) {
  std::vector<Window> windows;
  for (const auto& rows : repair_runs(columns, mapping).runs) {
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    std::size_t from = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t row = rows[i];
      const double difference = directions[1] * travel.values[1][i] - directions[0] * travel.values[0][i];
      if (!std::isfinite(std::abs(place_of(columns, row))) || !std::isfinite(columns.theta_rad[row]) ||
          !std::isfinite(difference))
        continue;
      if (from < rows.size() && columns.t_s[row] - columns.t_s[rows[from]] < frame_window_s) continue;
      if (from < rows.size()) {
        const std::size_t start = rows[from];
        const double before = directions[1] * travel.values[1][from] - directions[0] * travel.values[0][from];
        const double turned = wrapped(columns.theta_rad[row] - columns.theta_rad[start], turn);
        windows.push_back({place_of(columns, row) - place_of(columns, start),
                           columns.theta_rad[start] + 0.5 * turned, turned, difference - before});
      }
      from = i;
    }
  }
  return windows;
}

// How the headings go, in one unit of theirs.
struct Sense {
  double with = 0.0;     // 0 to 1: the direction of the motion turns as the heading does
  double against = 0.0;  // or against it
  double wheels = 0.0;   // correlation of the turns with those of the wheels
};

Sense sense_of(const std::vector<Window>& windows, double unit) {
  constexpr double longest_turn_rad = 1.0;
  std::complex<double> with = 0.0;
  std::complex<double> against = 0.0;
  double squares = 0.0;
  double products = 0.0;
  double turns = 0.0;
  double wheels = 0.0;
  for (const Window& window : windows) {
    if (std::abs(unit * window.turned) > longest_turn_rad) continue;
    // Twice the angle: a robot that drives backward moves against its heading.
    const double twice = 2.0 * unit * window.heading;
    with += window.moved * window.moved * std::polar(1.0, -twice);
    against += window.moved * window.moved * std::polar(1.0, twice);
    squares += std::norm(window.moved);
    products += window.turned * window.turn_of_wheels;
    turns += window.turned * window.turned;
    wheels += window.turn_of_wheels * window.turn_of_wheels;
  }
  if (!(turns > 0.0) || !(wheels > 0.0)) return {};
  const double correlation = products / std::sqrt(turns * wheels);
  if (!(squares > 0.0)) return {0.0, 0.0, correlation};
  return {std::abs(with) / squares, std::abs(against) / squares, correlation};
}

// That of radians or of degrees, whichever the motion follows more closely.
Sense find_sense(const DriveColumns& columns, const GivenMapping& given, const Mapping& mapping,
                 const std::array<double, 2>& directions) {
  const Sense as_read = sense_of(windows_of(columns, mapping, directions, 2.0 * pi), 1.0);
  if (!mapping.reference->theta || given.says("reference.angle_unit") ||
      mapping.reference->angle_unit != "rad")
    return as_read;
  const Sense degrees = sense_of(windows_of(columns, mapping, directions, 360.0), pi / 180.0);
  const auto best = [&columns](const Sense& sense) {
    return columns.x.empty() ? std::abs(sense.wheels) : std::max(sense.with, sense.against);
  };
  return best(degrees) > best(as_read) ? degrees : as_read;
}

bool can_be_judged(const DriveColumns& columns, const GivenMapping& given, const Mapping& mapping) {
  return mapping.reference && mapping.wheels && mapping.wheels->right && !mapping.wheels->body_motion &&
         mapping.wheels->kind != WheelKind::speed && !given.says("reference.heading") &&
         !given.says("reference.y_axis") && columns.x.empty() == columns.y.empty() &&
         !columns.theta_rad.empty() && !columns.wheel[1].empty();
}

}  // namespace

bool infer_reference_frame(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                           std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  constexpr double sure = 0.5;   // of 1
  constexpr double clear = 1.5;  // times the other sense
  if (!can_be_judged(columns, given, mapping)) return false;
  std::array<ResponseFit, 2> fits;
  if (mapping.command) {
    const auto rows = response_rows(columns, mapping);
    fits = {fit_response(rows[0]), fit_response(rows[1])};
  }
  const Sense sense = find_sense(columns, given, mapping, wheel_directions(mapping, fits));
  if (std::abs(sense.wheels) < sure) return false;
  const bool with_motion = sense.with > sure && sense.with > clear * sense.against;
  const bool against_motion = sense.against > sure && sense.against > clear * sense.with;
  const bool with_wheels = sense.wheels > 0.0;
  if (columns.x.empty() && !with_wheels) {
    mapping.reference->clockwise = true;
    findings.emplace_back("headings are clockwise: they turn against the wheels");
    return true;
  }
  if (against_motion && !with_wheels) {
    mapping.reference->clockwise = true;
    findings.emplace_back("headings are clockwise: x and y turn as the wheels do, and headings against them");
    return true;
  }
  if (against_motion) {
    mapping.reference->y_points_right = true;
    findings.emplace_back(
        "the places are mirrored, so that y points right or x and y are exchanged: headings turn as the "
        "wheels do, and x and y against them");
    return true;
  }
  if (with_motion && !with_wheels) {
    doubts.emplace_back(
        "x, y and heading turn right where the wheels turn left: in a frame whose z points down, --set "
        "reference.heading=clockwise --set reference.y_axis=right; else left and right are exchanged");
  }
  return false;
}

}  // namespace wheelwright::import
