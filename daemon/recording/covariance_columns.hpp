// A covariance of x, y, theta as the logs have it.
#pragma once

#include <Eigen/Core>
#include <array>

namespace wheelwright::daemon {

// xx, xy, yy, x theta, y theta, theta theta; m^2, m rad, rad^2.
inline std::array<double, 6> covariance_columns(const Eigen::Matrix3d& covariance) {
  return {covariance(0, 0), covariance(0, 1), covariance(1, 1),
          covariance(0, 2), covariance(1, 2), covariance(2, 2)};
}

}  // namespace wheelwright::daemon
