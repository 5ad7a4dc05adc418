#include "tools/wheelwright/import/conversion/local_metres.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace wheelwright::import {
namespace {

constexpr double degree_rad = std::numbers::pi / 180.0;

struct Fix {
  double longitude_deg = 0.0;
  double latitude_deg = 0.0;
  double metres_per_degree_east = 0.0;
  double metres_per_degree_north = 0.0;
};

Fix fix_at(double longitude_deg, double latitude_deg) {
  constexpr double semi_major_m = 6378137.0;
  constexpr double eccentricity_squared = 6.69437999014e-3;
  const double latitude = degree_rad * latitude_deg;
  const double factor = 1.0 - eccentricity_squared * std::sin(latitude) * std::sin(latitude);
  const double meridian_m = semi_major_m * (1.0 - eccentricity_squared) / (factor * std::sqrt(factor));
  const double transverse_m = semi_major_m / std::sqrt(factor);
  return {longitude_deg, latitude_deg, degree_rad * transverse_m * std::cos(latitude),
          degree_rad * meridian_m};
}

}  // namespace

LocalMetres local_metres(std::span<const double> longitude_deg, std::span<const double> latitude_deg) {
  LocalMetres result;
  std::optional<Fix> first;
  for (std::size_t i = 0; i < longitude_deg.size(); ++i) {
    const double longitude = longitude_deg[i];
    const double latitude = latitude_deg[i];
    result.east.push_back(std::numeric_limits<double>::quiet_NaN());
    result.north.push_back(std::numeric_limits<double>::quiet_NaN());
    if (longitude == 0.0 && latitude == 0.0) ++result.without_fix;
    if (!std::isfinite(longitude) || !std::isfinite(latitude) || (longitude == 0.0 && latitude == 0.0))
      continue;
    if (!first) first = fix_at(longitude, latitude);
    result.east.back() = first->metres_per_degree_east * (longitude - first->longitude_deg);
    result.north.back() = first->metres_per_degree_north * (latitude - first->latitude_deg);
  }
  return result;
}

}  // namespace wheelwright::import
