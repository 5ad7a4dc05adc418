#include "model/gap/candidates/region_scale.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace wheelwright::gap {

double region_scale(const FitProblem& problem) {
  constexpr double room_m = 2.5;
  Eigen::AlignedBox2d floor;
  for (const GapRun& run : problem.runs()) {
    for (const Reference& reference : run.references)
      floor.extend(Eigen::Vector2d(reference.pose.x_m, reference.pose.y_m));
  }
  return floor.isEmpty() ? 1.0 : std::max(1.0, floor.sizes().maxCoeff() / room_m);
}

}  // namespace wheelwright::gap
