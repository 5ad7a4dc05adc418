#include "tools/wheelwright/import/inference/wanted_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t way_rows = 5;  // rows over which a way stands out from noise
constexpr long max_lag = 100;        // rows

// How far it goes around each row.
std::vector<double> ways(const PlacePath& path) {
  std::vector<double> result;
  for (std::size_t i = way_rows; i < path.x.size(); ++i)
    result.push_back(std::hypot(path.x[i] - path.x[i - way_rows], path.y[i] - path.y[i - way_rows]));
  return result;
}

// Of one[i] and other[i + lag].
double correlation_at(const std::vector<double>& one, const std::vector<double>& other, long lag) {
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  const auto size = static_cast<long>(one.size());
  for (long i = std::max(0L, -lag); i < std::min(size, size - lag); ++i) {
    const double a = one[static_cast<std::size_t>(i)];
    const double b = other[static_cast<std::size_t>(i + lag)];
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    n += 1;
    sa += a;
    sb += b;
    saa += a * a;
    sbb += b * b;
    sab += a * b;
  }
  const double variances = (saa - sa * sa / n) * (sbb - sb * sb / n);
  return n > 20.0 && variances > 0.0 ? (sab - sa * sb / n) / std::sqrt(variances) : 0.0;
}

// Rows by which the other comes behind; negative where it goes before.
long lag_of(const std::vector<double>& one, const std::vector<double>& other) {
  constexpr double clearly = 0.02;  // of a correlation
  const long longest = std::min(max_lag, static_cast<long>(one.size() / 10));
  const double at_once = correlation_at(one, other, 0);
  long best = 0;
  double highest = at_once + clearly;
  for (long lag = -longest; lag <= longest; ++lag) {
    const double found = correlation_at(one, other, lag);
    if (found <= highest) continue;
    highest = found;
    best = lag;
  }
  return best;
}

// Median size of the second differences.
double roughness(const PlacePath& path) {
  std::vector<double> sizes;
  for (std::size_t i = 2; i < path.x.size(); ++i) {
    const double size = std::hypot(path.x[i] - 2.0 * path.x[i - 1] + path.x[i - 2],
                                   path.y[i] - 2.0 * path.y[i - 1] + path.y[i - 2]);
    if (std::isfinite(size)) sizes.push_back(size);
  }
  return sizes.empty() ? 0.0 : median(std::move(sizes));
}

}  // namespace

PathKind path_kind(const PlacePath& path, const PlacePath& other) {
  constexpr long clear_lag = 2;
  constexpr double much_rougher = 3.0;
  if (is_held(path.x) && is_held(path.y) && !is_held(other.x)) return PathKind::wanted;
  const long lag = lag_of(ways(path), ways(other));
  if (lag >= clear_lag) return PathKind::wanted;
  if (lag <= -clear_lag) return PathKind::measured;
  const double noise = roughness(path);
  const double noise_of_other = roughness(other);
  if (noise_of_other > much_rougher * noise) return PathKind::wanted;
  return noise > much_rougher * noise_of_other ? PathKind::measured : PathKind::unclear;
}

}  // namespace wheelwright::import
