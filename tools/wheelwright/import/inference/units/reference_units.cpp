#include "tools/wheelwright/import/inference/units/reference_units.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/path_scale.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using std::numbers::pi;

struct HeadingUnit {
  const char* name;
  const char* words;
  double degrees;
};

constexpr std::array heading_units{HeadingUnit{"deg", "degrees", 1.0},
                                   HeadingUnit{"0.1deg", "tenths of a degree", 0.1},
                                   HeadingUnit{"0.01deg", "hundredths of a degree", 0.01}};
constexpr double largest_turn_deg = 150.0;  // between two rows: a larger one starts again behind a turn

class ReferenceUnits {
 public:
  ReferenceUnits(const DriveColumns& columns, const GivenMapping& given,
                 const std::array<double, 2>& directions, Mapping& mapping,
                 std::vector<std::string>& findings)
      : columns_(columns), given_(given), directions_(directions), mapping_(mapping), findings_(findings) {}

  // Heading and place against those of the counts, over windows of some rows.
  void run() {
    const double scale = wheel_scale(*mapping_.wheels).value_or(0.0);
    if (!(scale > 0.0) || columns_.wheel[1].empty() || mapping_.wheels->kind == WheelKind::speed) return;
    std::array<double, 3> turn_products{};
    std::array<double, 3> turn_squares{};
    double way = 0.0;
    double reference_way = 0.0;
    const TimeRepair time = repair_runs(columns_, mapping_);
    for (const auto& rows : time.runs) {
      const WheelTravel travel = travel_of(rows);
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
          for (std::size_t k = 0; k < heading_units.size(); ++k) {
            if (std::abs(seen) >= largest_turn_deg / heading_units[k].degrees) continue;
            turn_products[k] += turn * seen;
            turn_squares[k] += turn * turn;
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
    for (std::size_t k = 0; k < heading_units.size(); ++k) {
      if (turn_squares[k] > 0.0) heading_unit(heading_units[k], turn_products[k] / turn_squares[k]);
    }
    if (way > 0.0) place_unit(reference_way / way);
  }

 private:
  WheelTravel travel_of(const std::vector<std::size_t>& rows) const {
    WheelTravel travel = wheel_travel(columns_, rows, mapping_);
    for (std::size_t side = 0; side < 2; ++side) {
      for (double& value : travel.values[side]) value *= directions_[side];
    }
    return travel;
  }

  bool is_placed(std::size_t row) const {
    const auto stands = [row](const Column& column) { return column.empty() || std::isfinite(column[row]); };
    return stands(columns_.x) && stands(columns_.y) && stands(columns_.theta_rad);
  }

  void heading_unit(const HeadingUnit& unit, double signed_slope) {
    const double slope = std::abs(signed_slope);
    ReferenceMapping& reference = *mapping_.reference;
    if (!reference.theta || given_.says("reference.angle_unit") || reference.angle_unit != "rad" ||
        !is_near(slope, 180.0 / pi / unit.degrees))
      return;
    reference.angle_unit = unit.name;
    findings_.push_back(std::string("headings are in ") + unit.words + ": they turn " +
                        fixed_number(slope, 1) + " times as far as the counts in radians");
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
      findings_.push_back("places are in " + reference.unit + ": they go " +
                          fixed_number(ratio, ratio < 10.0 ? 2 : 0) +
                          " times as far as the counts in metres");
    }
  }

  const DriveColumns& columns_;
  const GivenMapping& given_;
  std::array<double, 2> directions_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
};

}  // namespace

bool set_scale_by_reference(const DriveColumns& columns, const GivenMapping& given,
                            const std::array<double, 2>& directions, bool has_to_agree, Mapping& mapping,
                            std::vector<std::string>& findings) {
  WheelMapping& wheels = *mapping.wheels;
  const bool is_angle = wheels.kind == WheelKind::angle;
  if (wheels.kind != WheelKind::counts && !is_angle) return false;
  const auto by_path = path_scale(columns, mapping, directions);
  if (!by_path) return false;
  const auto by_turns = turn_scale(columns, mapping, directions, by_path->angle_in_rad);
  if (has_to_agree && !by_turns) return false;
  ReferenceMapping reference = *mapping.reference;
  double scale = by_path->metres_per_unit;
  const bool unit_is_free = !given.says("reference.unit") && reference.unit == "m";
  for (const char* unit : {"mm", "cm"}) {
    const double metres = in_si(distance_units(), unit);
    if (!by_turns || !unit_is_free || !is_near(metres * by_path->metres_per_unit / *by_turns, 1.0)) continue;
    reference.unit = unit;
    scale = metres * by_path->metres_per_unit;
  }
  if (has_to_agree && !is_near(scale / *by_turns, 1.0)) return false;
  constexpr double longest_count_m = 1.0;
  if (scale < 1e-9 || scale > longest_count_m) return false;
  mapping.reference = reference;
  auto& found = is_angle ? wheels.wheel_radius_m : wheels.metres_per_count;
  found = rounded_gain(is_angle ? scale / in_si(angle_units(), wheels.unit) : scale);
  wheels.scale_from = from_reference;
  findings.push_back((is_angle ? "the wheel radius is " : "a count is ") + config::plain_number(*found) +
                     " m, so that the wheels go as far as the reference, whose places are in " +
                     reference.unit + "; --set wheels." + (is_angle ? "wheel_radius_m" : "metres_per_count") +
                     " if you know it");
  return true;
}

void set_reference_units(const DriveColumns& columns, const GivenMapping& given,
                         const std::array<double, 2>& directions, Mapping& mapping,
                         std::vector<std::string>& findings) {
  ReferenceUnits(columns, given, directions, mapping, findings).run();
}

}  // namespace wheelwright::import
