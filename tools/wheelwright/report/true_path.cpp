#include "tools/wheelwright/report/true_path.hpp"

#include <cmath>

#include "model/geometry/pose.hpp"

namespace wheelwright::tools {
namespace {

constexpr double long_stand_s = 0.9;
constexpr double moving_m_s = 1e-3;

}  // namespace

TruePath true_path(const config::CsvTable& truth) {
  const auto t = truth.numbers("t");
  const auto x = truth.numbers("x");
  const auto y = truth.numbers("y");
  const auto theta = truth.numbers("theta");
  const auto left = truth.numbers("speed_left");
  const auto right = truth.numbers("speed_right");
  std::size_t start = 0;
  double standing_since_s = t.front();
  bool stands = true;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool moves = std::hypot(left[i], right[i]) > moving_m_s;
    if (moves && stands && t[i] - standing_since_s > long_stand_s) start = i > 0 ? i - 1 : 0;
    if (!moves && !stands) standing_since_s = t[i];
    stands = !moves;
  }
  TruePath path;
  const Pose origin{x[start], y[start], theta[start]};
  const std::size_t stride = std::max<std::size_t>(1, (t.size() - start) / 1500);
  for (std::size_t i = start; i < t.size(); i += stride) {
    const Pose pose = between(origin, {x[i], y[i], theta[i]});
    path.points.push_back({pose.x_m, pose.y_m});
  }
  path.closure_m = std::hypot(x.back() - origin.x_m, y.back() - origin.y_m);
  return path;
}

}  // namespace wheelwright::tools
