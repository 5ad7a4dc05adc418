#include "tools/wheelwright/import/inference/gyro_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using config::plain_number;

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double window_s = 0.25;
constexpr double gyro_explained = 0.7;
constexpr std::size_t min_windows = 20;
constexpr double max_rad_s = 36.0;  // 2000 deg/s, which gyros on robots measure at most
constexpr double known_within = 0.05;

struct GyroSlope {
  double slope = 0.0;
  double explained = 0.0;
};

// Of the gyro's mean over windows against the turn rate by the counts, with an offset: raw numbers have one.
class TurnRegression {
 public:
  void add(double turn_rate, double gyro) {
    n_ += 1.0;
    sum_turn_ += turn_rate;
    sum_gyro_ += gyro;
    turn_squares_ += turn_rate * turn_rate;
    gyro_squares_ += gyro * gyro;
    products_ += turn_rate * gyro;
  }
  std::optional<GyroSlope> slope() const {
    if (n_ < static_cast<double>(min_windows)) return std::nullopt;
    const double turn = turn_squares_ - sum_turn_ * sum_turn_ / n_;
    const double gyro = gyro_squares_ - sum_gyro_ * sum_gyro_ / n_;
    const double both = products_ - sum_turn_ * sum_gyro_ / n_;
    if (!(turn > 0.0) || !(gyro > 0.0)) return std::nullopt;
    return GyroSlope{both / turn, both * both / (turn * gyro)};
  }

 private:
  double n_ = 0.0, sum_turn_ = 0.0, sum_gyro_ = 0.0, turn_squares_ = 0.0, gyro_squares_ = 0.0,
         products_ = 0.0;
};

std::optional<GyroSlope> slope_of(const DriveColumns& columns, const Mapping& mapping) {
  const bool has_turns = mapping.wheels && mapping.wheels->right &&
                         mapping.wheels->kind != WheelKind::speed && mapping.wheel_base_m;
  const auto scale = has_turns ? wheel_scale(*mapping.wheels) : std::nullopt;
  if (!scale) return std::nullopt;
  TurnRegression regression;
  const TimeRepair time = repair_runs(columns, mapping);
  for (const auto& rows : time.runs) {
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    std::size_t from = 0;
    double sum = 0.0;
    double count = 0.0;
    const auto difference = [&](std::size_t i) {
      return *scale * (travel.values[1][i] - travel.values[0][i]);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double gyro = columns.gyro[rows[i]];
      if (i > from && std::isfinite(gyro)) {
        sum += gyro;
        count += 1.0;
      }
      const double duration_s = time.t_s[rows[i]] - time.t_s[rows[from]];
      if (duration_s < window_s || count == 0.0) continue;
      const double rate = (difference(i) - difference(from)) / *mapping.wheel_base_m / duration_s;
      if (std::isfinite(rate)) regression.add(rate, sum / count);
      from = i;
      sum = count = 0.0;
    }
  }
  return regression.slope();
}

// Raw numbers per deg/s of usual gyros at their ranges.
struct KnownScale {
  double per_deg_s;
  std::string_view sensor;
};
constexpr std::array known_scales{KnownScale{131.0, "MPU-6050 and alike at 250 deg/s"},
                                  KnownScale{65.5, "MPU-6050 and alike at 500 deg/s"},
                                  KnownScale{32.8, "MPU-6050 and alike at 1000 deg/s"},
                                  KnownScale{16.4, "MPU-6050 and alike at 2000 deg/s"},
                                  KnownScale{114.29, "L3G and LSM gyros at 245 deg/s"},
                                  KnownScale{57.14, "L3G and LSM gyros at 500 deg/s"},
                                  KnownScale{14.286, "L3G and LSM gyros at 2000 deg/s"},
                                  KnownScale{1000.0, "thousandths of deg/s"}};

void take_raw(double slope, Mapping& mapping, std::vector<std::string>& findings) {
  const double per_deg_s = slope / degrees;
  const auto* const nearest = std::ranges::min_element(known_scales, {}, [&](const KnownScale& known) {
    return std::abs(std::log(per_deg_s / known.per_deg_s));
  });
  const bool is_known = std::abs(per_deg_s / nearest->per_deg_s - 1.0) < known_within;
  mapping.gyro->unit = raw_unit;
  mapping.gyro->lsb_per_deg_s = is_known ? nearest->per_deg_s : rounded_gain(per_deg_s);
  findings.push_back("the gyro is in raw numbers, " + plain_number(*mapping.gyro->lsb_per_deg_s) +
                     " for a deg/s" + (is_known ? " (" + std::string(nearest->sensor) + ")" : "") +
                     ": by the wheels it is " + fixed_number(per_deg_s, 1) +
                     "; --set gyro.lsb_per_deg_s if you know it");
}

}  // namespace

void set_gyro_unit(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  if (!mapping.gyro || given.says("gyro.unit") || given.says("gyro.lsb_per_deg_s")) return;
  ScalarMapping& gyro = *mapping.gyro;
  const auto found = slope_of(columns, mapping);
  if (!found || found->explained < gyro_explained) {
    if (!gyro.unit_is_stated && largest(columns.gyro) > max_rad_s)
      doubts.push_back(
          "the gyro goes up to " + plain_number(largest(columns.gyro)) +
          ", which is no rad/s, and the wheels do not show its unit; give it: --set gyro.unit=deg/s "
          "or gyro.lsb_per_deg_s=131");
    return;
  }
  if (found->slope < 0.0)
    doubts.push_back("the gyro turns against the wheels: it counts clockwise, or the sides are swapped");
  const double slope = std::abs(found->slope);
  const double stated = 1.0 / in_si(angular_units(), gyro.unit);
  if (is_near(slope, stated)) return;
  if (gyro.unit_is_stated) {
    doubts.push_back("the gyro turns " + plain_number(rounded_gain(slope / stated)) +
                     " times as far as the wheels in " + gyro.unit + ": check its unit and the wheel base");
    return;
  }
  for (const Unit& unit : angular_units()) {
    const bool is_raw = are_whole(columns.gyro) && unit.name == "mrad/s";
    if (is_raw || unit.name == "rpm" || !is_near(slope, 1.0 / unit.in_si)) continue;
    gyro.unit = unit.name;
    findings.push_back("the gyro is in " + gyro.unit + ": it turns " + fixed_number(slope, 1) +
                       " times as far as the wheels in radians");
    return;
  }
  if (slope > 2.0 * degrees) return take_raw(slope, mapping, findings);
  doubts.push_back("the gyro turns " + plain_number(rounded_gain(slope)) +
                   " times as far as the wheels in rad/s: check its unit and the wheel base");
}

}  // namespace wheelwright::import
