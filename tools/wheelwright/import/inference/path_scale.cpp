#include "tools/wheelwright/import/inference/path_scale.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/reference_poses.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {
namespace {

using std::numbers::pi;
using Plane = std::vector<std::complex<double>>;

constexpr double min_explained = 0.9;
constexpr double unclear_rad = 0.5;  // of a turn by more between two rows it is not known how the way went

std::complex<double> mean(const Plane& places) {
  std::complex<double> sum;
  for (const auto& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

// Least squares of places = slope * path + offset of each segment, also with a marker off the axle:
//
//   places = slope * path + arm * exp(i heading) + offset,    slope: real, arm: complex
struct FittedSlope {
  double products = 0.0;
  double path_squares = 0.0;
  double place_squares = 0.0;
  std::complex<double> path_by_heading;
  std::complex<double> places_by_heading;
  double heading_squares = 0.0;

  void add(const Plane& path, const Plane& places, const Plane& headings) {
    if (path.empty()) return;
    const auto path_mean = mean(path);
    const auto place_mean = mean(places);
    const auto heading_mean = mean(headings);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto on_path = path[i] - path_mean;
      const auto place = places[i] - place_mean;
      const auto heading = headings[i] - heading_mean;
      products += std::real(place * std::conj(on_path));
      path_squares += std::norm(on_path);
      place_squares += std::norm(place);
      path_by_heading += on_path * std::conj(heading);
      places_by_heading += place * std::conj(heading);
      heading_squares += std::norm(heading);
    }
  }

  double slope() const { return products / path_squares; }
  double explained() const {
    return path_squares > 0.0 && place_squares > 0.0 ? products * products / (path_squares * place_squares)
                                                     : 0.0;
  }

  // With an arm, where that leaves less than half of the squares, and the path is no circle about the axle.
  double slope_with_arm() const {
    constexpr double clearly_less = 0.5;
    constexpr double least_path = 0.05;  // of its squares, beyond what the arm can do
    if (!(heading_squares > 0.0)) return slope();
    FittedSlope rest = *this;
    rest.products -= std::real(places_by_heading * std::conj(path_by_heading)) / heading_squares;
    rest.path_squares -= std::norm(path_by_heading) / heading_squares;
    rest.place_squares -= std::norm(places_by_heading) / heading_squares;
    const auto left = [](const FittedSlope& fit) {
      return fit.place_squares - fit.products * fit.products / fit.path_squares;
    };
    return rest.path_squares > least_path * path_squares && left(rest) < clearly_less * left(*this)
               ? rest.slope()
               : slope();
  }
};

class PathSlope {
 public:
  PathSlope(const DriveColumns& columns, const Mapping& mapping, const std::array<double, 2>& directions)
      : columns_(columns), mapping_(mapping), directions_(directions) {}

  FittedSlope slope(double angle_in_rad) const {
    FittedSlope slope;
    for (const auto& rows : repair_runs(columns_, mapping_).runs) add_run(rows, angle_in_rad, slope);
    return slope;
  }

 private:
  bool is_placed(std::size_t row) const {
    return std::isfinite(columns_.x[row]) && std::isfinite(columns_.y[row]) &&
           std::isfinite(columns_.theta_rad[row]);
  }

  // A pose that is logged more often than it is measured is that of an earlier row.
  bool is_held(std::size_t row) const {
    return row > 0 && columns_.x[row] == columns_.x[row - 1] && columns_.y[row] == columns_.y[row - 1] &&
           columns_.theta_rad[row] == columns_.theta_rad[row - 1];
  }

  void add_run(const std::vector<std::size_t>& rows, double angle_in_rad, FittedSlope& slope) const {
    const double unit_m = place_in_m(*mapping_.reference);
    const WheelTravel travel = wheel_travel(columns_, rows, mapping_);
    Plane path, places, headings;
    double last_way = 0.0;
    double last_heading = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double way = 0.5 * (directions_[0] * travel.values[0][i] + directions_[1] * travel.values[1][i]);
      if (!is_placed(rows[i]) || !std::isfinite(way) || (!path.empty() && is_held(rows[i]))) continue;
      const double heading = angle_in_rad * columns_.theta_rad[rows[i]];
      const double turn = std::remainder(heading - last_heading, 2.0 * pi);
      if (!path.empty() && std::abs(turn) > unclear_rad) {
        slope.add(path, places, headings);
        path.clear();
        places.clear();
        headings.clear();
      }
      path.push_back(path.empty() ? std::complex<double>()
                                  : path.back() + std::polar(1.0, heading - 0.5 * turn) * (way - last_way));
      places.push_back(unit_m * std::complex<double>(columns_.x[rows[i]], columns_.y[rows[i]]));
      headings.push_back(std::polar(1.0, heading));
      last_way = way;
      last_heading = heading;
    }
    slope.add(path, places, headings);
  }

  const DriveColumns& columns_;
  const Mapping& mapping_;
  const std::array<double, 2>& directions_;
};

}  // namespace

std::optional<PathScale> path_scale(const DriveColumns& columns, const Mapping& mapping,
                                    const std::array<double, 2>& directions) {
  if (!mapping.reference || !mapping.wheels || mapping.wheels->kind == WheelKind::speed ||
      columns.x.empty() || columns.y.empty() || columns.theta_rad.empty() || columns.wheel[1].empty())
    return std::nullopt;
  const PathSlope path(columns, mapping, directions);
  constexpr double degree = pi / 180.0;
  const FittedSlope radians = path.slope(1.0);
  const FittedSlope degrees = path.slope(degree);
  const bool in_degrees = degrees.explained() > radians.explained();
  const FittedSlope& best = in_degrees ? degrees : radians;
  if (best.explained() < min_explained || best.products < 0.0) return std::nullopt;
  return PathScale{best.slope_with_arm(), in_degrees ? degree : 1.0};
}

std::optional<double> turn_scale(const DriveColumns& columns, const Mapping& mapping,
                                 const std::array<double, 2>& directions, double angle_in_rad) {
  if (!mapping.wheel_base_m || columns.theta_rad.empty() || columns.wheel[1].empty()) return std::nullopt;
  double products = 0.0;
  double squares = 0.0;
  for (const auto& rows : repair_runs(columns, mapping).runs) {
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    const auto apart = [&](std::size_t i) {
      return directions[1] * travel.values[1][i] - directions[0] * travel.values[0][i];
    };
    constexpr std::size_t window = 10;  // rows, so that the turn stands out from the noise
    for (std::size_t i = window; i < rows.size(); i += window) {
      const double turn = std::remainder(
          angle_in_rad * (columns.theta_rad[rows[i]] - columns.theta_rad[rows[i - window]]), 2.0 * pi);
      const double counts = apart(i) - apart(i - window);
      if (!std::isfinite(turn) || !std::isfinite(counts) || std::abs(turn) > 2.0) continue;
      products += turn * counts;
      squares += counts * counts;
    }
  }
  if (!(squares > 0.0) || !(products > 0.0)) return std::nullopt;
  return *mapping.wheel_base_m * products / squares;
}

}  // namespace wheelwright::import
