#include "tools/wheelwright/import/inference/floor_plane.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {
namespace {

double spread(const std::vector<double>& values) {
  constexpr double outermost = 0.01;
  std::vector<double> finite;
  for (const double value : values) {
    if (std::isfinite(value)) finite.push_back(value);
  }
  if (finite.size() < 2) return 0.0;
  return quantile(finite, 1.0 - outermost) - quantile(finite, outermost);
}

}  // namespace

FloorPlane floor_plane(const std::vector<double>& x, const std::vector<double>& y,
                       const std::vector<double>& z) {
  constexpr double height = 0.1;
  constexpr double steepest = 0.25;
  constexpr double clearly = 3.0;
  const double along_x = spread(x);
  const double along_y = spread(y);
  const double along_z = spread(z);
  if (along_y < height * along_z && along_z > steepest * along_x) return FloorPlane::z_x;
  return along_z > clearly * along_y && along_z > height * along_x ? FloorPlane::unclear : FloorPlane::x_y;
}

bool folds_heading(const std::vector<double>& roll, const std::vector<double>& heading, double turn) {
  constexpr double few = 0.01;  // of the rows
  std::size_t turned = 0;
  for (const double angle : roll) {
    if (std::isfinite(angle) && std::abs(std::remainder(angle, turn)) > 0.25 * turn) ++turned;
  }
  return static_cast<double>(turned) > few * static_cast<double>(roll.size()) &&
         largest(heading) < 0.26 * turn;
}

}  // namespace wheelwright::import
