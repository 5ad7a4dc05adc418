#include "model/gap/noise/segment_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr double walk_m_per_sqrt_s = 1e-3;
constexpr double walk_rad_per_sqrt_s = 2e-3;

}  // namespace

Eigen::Matrix3d default_segment_covariance(const GapRun& run, std::size_t segment) {
  const Reference& from = run.references[segment];
  const Reference& to = run.references[segment + 1];
  const std::size_t first = from.at.period;
  const std::size_t last = std::max(to.at.period, first + 1);
  std::vector<Pose> path{Pose{}};
  const Pose end = between(from.pose, to.pose);
  for (std::size_t k = first; k < last; ++k) {
    const double share = 1.0 / static_cast<double>(last - first);
    path.push_back(
        run.has_counts && k < run.odometry.size()
            ? move_along_arc(path.back(), {run.odometry[k].forward_m, run.odometry[k].turn_rad}, 1.0)
            : Pose{path.back().x_m + share * end.x_m, path.back().y_m + share * end.y_m,
                   path.back().theta_rad + share * end.theta_rad});
  }
  const PoseNoise reading = run.reference_noise.value_or(PoseNoise{});
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const auto lever = [&](const Pose& at) {
    return Eigen::Vector3d(-(path.back().y_m - at.y_m), path.back().x_m - at.x_m, 1.0);
  };
  for (const Pose& at : path) {
    const Eigen::Vector3d along(std::cos(at.theta_rad), std::sin(at.theta_rad), 0.0);
    covariance += run.period_s * walk_m_per_sqrt_s * walk_m_per_sqrt_s * along * along.transpose();
    covariance +=
        run.period_s * walk_rad_per_sqrt_s * walk_rad_per_sqrt_s * lever(at) * lever(at).transpose();
  }
  const Eigen::Vector3d start = lever(path.front());
  const double position_variance = reading.position_m * reading.position_m;
  const double heading_variance = reading.heading_rad * reading.heading_rad;
  covariance += heading_variance * start * start.transpose();
  covariance +=
      Eigen::Vector3d(2.0 * position_variance, 2.0 * position_variance, heading_variance).asDiagonal();
  // Nothing is known of x and y, and so nothing of the heading by them.
  if (run.heading_alone) covariance = Eigen::Matrix3d(covariance.diagonal().asDiagonal());
  return covariance;
}

}  // namespace wheelwright::gap
