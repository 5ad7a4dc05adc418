#include "tools/wheelwright/import/inference/reference_units.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/gain_units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using std::numbers::pi;

class ReferenceUnits {
 public:
  ReferenceUnits(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                 std::vector<std::string>& findings)
      : columns_(columns), given_(given), mapping_(mapping), findings_(findings) {}

  // Heading and place against those of the counts, over windows of some rows.
  void run() {
    const double scale = wheel_scale(*mapping_.wheels).value_or(0.0);
    if (!(scale > 0.0) || columns_.wheel[1].empty() || mapping_.wheels->kind == WheelKind::speed) return;
    double turn_products = 0.0;
    double turn_squares = 0.0;
    double way = 0.0;
    double reference_way = 0.0;
    const TimeRepair time = repair_runs(columns_, mapping_);
    for (const auto& rows : time.runs) {
      const WheelTravel travel = wheel_travel(columns_, rows, mapping_);
      std::size_t before = rows.size();
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!is_placed(rows[i]) || !std::isfinite(travel.values[0][i]) || !std::isfinite(travel.values[1][i]))
          continue;
        if (before == rows.size()) before = i;
        const double left = scale * (travel.values[0][i] - travel.values[0][before]);
        const double right = scale * (travel.values[1][i] - travel.values[1][before]);
        if (std::abs(left) + std::abs(right) < 0.1) continue;  // metres: enough to show beside noise
        const double turn = (right - left) / *mapping_.wheel_base_m;
        if (!columns_.theta_rad.empty() && std::abs(turn) < 2.0) {
          const double seen = columns_.theta_rad[rows[i]] - columns_.theta_rad[rows[before]];
          if (std::abs(seen) < 150.0) {
            turn_products += turn * seen;
            turn_squares += turn * turn;
          }
        }
        if (!columns_.x.empty()) {
          way += std::abs(0.5 * (left + right));
          reference_way += std::hypot(columns_.x[rows[i]] - columns_.x[rows[before]],
                                      columns_.y[rows[i]] - columns_.y[rows[before]]);
        }
        before = i;
      }
    }
    if (turn_squares > 0.0) heading_unit(turn_products / turn_squares);
    if (way > 0.0) place_unit(reference_way / way);
    if (mapping_.wheels->scale_from == "commands") scale_by_reference(time);
  }

 private:
  bool is_placed(std::size_t row) const {
    const auto stands = [row](const Column& column) { return column.empty() || std::isfinite(column[row]); };
    return stands(columns_.x) && stands(columns_.y) && stands(columns_.theta_rad);
  }

  // A scale that was taken from the commands takes their gain for one. Who knows where the robot was knows
  // better: the slope of its places over the path that the wheels go along its headings, each about its mean.
  void scale_by_reference(const TimeRepair& time) {
    if (columns_.x.empty() || columns_.theta_rad.empty()) return;
    Slope slope;
    for (const auto& rows : time.runs) add_run(rows, slope);
    const double ratio = slope.squares > 0.0 ? slope.products / slope.squares : 0.0;
    if (is_near(ratio, 1.0)) take_scale(ratio);
  }

  struct Slope {
    double products = 0.0;
    double squares = 0.0;

    void add(const std::vector<std::complex<double>>& path, const std::vector<std::complex<double>>& places) {
      if (path.empty()) return;
      std::complex<double> path_mean, place_mean;
      for (const auto& at : path) path_mean += at / static_cast<double>(path.size());
      for (const auto& at : places) place_mean += at / static_cast<double>(path.size());
      for (std::size_t i = 0; i < path.size(); ++i) {
        products += std::real((places[i] - place_mean) * std::conj(path[i] - path_mean));
        squares += std::norm(path[i] - path_mean);
      }
    }
  };

  // Of a turn between two rows by more than `unclear_rad` it is not known how the way went.
  void add_run(const std::vector<std::size_t>& rows, Slope& slope) const {
    constexpr double unclear_rad = 0.5;
    const double scale = *wheel_scale(*mapping_.wheels);
    const WheelTravel travel = wheel_travel(columns_, rows, mapping_);
    std::vector<std::complex<double>> path, places;
    double last_way = 0.0;
    double last_heading = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double way = 0.5 * scale * (travel.values[0][i] + travel.values[1][i]);
      if (!is_placed(rows[i]) || !std::isfinite(way)) continue;
      const double heading = angle_in_rad_ * columns_.theta_rad[rows[i]];
      const double turn = std::remainder(heading - last_heading, 2.0 * pi);
      if (!path.empty() && std::abs(turn) > unclear_rad) {
        slope.add(path, places);
        path.clear();
        places.clear();
      }
      const auto before = path.empty() ? std::complex<double>() : path.back();
      path.push_back(path.empty() ? before
                                  : before + std::polar(1.0, heading - 0.5 * turn) * (way - last_way));
      places.push_back(place_in_m_ * std::complex<double>(columns_.x[rows[i]], columns_.y[rows[i]]));
      last_way = way;
      last_heading = heading;
    }
    slope.add(path, places);
  }

  void take_scale(double ratio) {
    WheelMapping& wheels = *mapping_.wheels;
    auto& assumed = wheels.metres_per_count ? wheels.metres_per_count : wheels.wheel_radius_m;
    const std::string what = wheels.metres_per_count ? "a count is " : "the wheel radius is ";
    const std::string key = wheels.metres_per_count ? "wheels.metres_per_count" : "wheels.wheel_radius_m";
    if (!assumed) return;
    std::erase_if(findings_, [&](const std::string& finding) { return finding.starts_with(what); });
    const double asked = *assumed;
    assumed = rounded_gain(ratio * asked);
    wheels.scale_from = "reference";
    findings_.push_back(what + config::plain_number(*assumed) +
                        " m, so that the wheels go as far as the reference; --set " + key +
                        " if you know it (for the speeds that are asked for it would have to be " +
                        config::plain_number(asked) + " m)");
  }

  void heading_unit(double slope) {
    ReferenceMapping& reference = *mapping_.reference;
    if (!reference.theta || given_.says("reference.angle_unit") || reference.angle_unit != "rad" ||
        !is_near(slope, 180.0 / pi))
      return;
    reference.angle_unit = "deg";
    angle_in_rad_ = pi / 180.0;
    findings_.push_back("headings are in degrees: they turn " + fixed_number(slope, 1) +
                        " times as far as the counts in radians");
  }

  void place_unit(double ratio) {
    ReferenceMapping& reference = *mapping_.reference;
    if (given_.says("reference.unit") || reference.unit != "m") return;
    struct PlaceUnit {
      const char* name;
      double per_metre;
      double tolerance;  // feet and inches are near other scales
    };
    for (const auto& [unit, per_metre, tolerance] : {PlaceUnit{"mm", 1000.0, near_gain},
                                                     {"cm", 100.0, near_gain},
                                                     {"ft", 1.0 / 0.3048, 1.06},
                                                     {"inch", 1.0 / 0.0254, 1.06}}) {
      if (std::abs(std::log(ratio / per_metre)) > std::log(tolerance)) continue;
      reference.unit = unit;
      place_in_m_ = 1.0 / per_metre;
      findings_.push_back("places are in " + reference.unit + ": they go " +
                          fixed_number(ratio, ratio < 10.0 ? 2 : 0) +
                          " times as far as the counts in metres");
    }
  }

  const DriveColumns& columns_;
  const GivenMapping& given_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
  double angle_in_rad_ = 1.0;  // of the columns, once their unit is found
  double place_in_m_ = 1.0;
};

}  // namespace

void set_reference_units(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings) {
  ReferenceUnits(columns, given, mapping, findings).run();
}

}  // namespace wheelwright::import
