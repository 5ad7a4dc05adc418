// A pose and how sure it is, carried along arcs.
//
// Noise is new in each period, N <- F N F' + G Q G'. Two errors are the same in every period, and what each
// does to the pose adds up along the way. That of the scale of both wheels is small, d <- F d + G e. That of
// the difference of their rolling radii, which turning in place cannot show, bends the whole way: a pose p+
// is carried for a difference of one standard deviation and p- for the opposite one. With
//   d = (p+ - p-) / 2,  c = (p+ + p-) / 2 - p,
// the end lies at p + z d + z^2 c, z standard normal, to second order (E z^2 = 1, E z^4 = 3), and the mean
// square error of p is d d' + 3 c c'. The covariance is the sum of all.
#pragma once

#include <Eigen/Core>
#include <array>

#include "model/geometry/pose.hpp"

namespace wheelwright {

// Covariance of one period's wheel travel, apart from the errors that are the same in every period.
struct TravelVariance {
  double left_m2 = 0.0;
  double right_m2 = 0.0;
  double both_m2 = 0.0;  // covariance of left and right
};

// Standard deviations, as fractions.
struct SystematicErrors {
  double scale = 0.0;  // of the travel of both wheels
  // Of the right wheel's radius over the left one's, each wheel having half of it.
  double wheel_mismatch = 0.0;
};

class PoseWithCovariance {
 public:
  PoseWithCovariance(double wheel_base_m, const SystematicErrors& systematic)
      : wheel_base_m_(wheel_base_m), systematic_(systematic) {}

  // Both wheels have rolled so far; `beyond` is what the body has moved beyond the wheels' travel (way in m,
  // turn in rad), as slip and geometry have it.
  void move(const WheelPair& rolled_m, const TravelVariance& variance, const Twist& beyond = {});

  // Starts again at a pose that is known, or known with this covariance.
  void reset(const Pose& pose, const Eigen::Matrix3d& covariance = Eigen::Matrix3d::Zero());

  double wheel_base_m() const { return wheel_base_m_; }
  const Pose& pose() const { return pose_; }
  // Of x, y (m) and theta (rad), in the frame of the pose.
  Eigen::Matrix3d covariance() const;

 private:
  double wheel_base_m_;
  SystematicErrors systematic_;
  Pose pose_;
  Eigen::Matrix3d noise_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d by_scale_ = Eigen::Vector3d::Zero();
  std::array<Pose, 2> by_mismatch_;  // for wheels that differ by one standard deviation either way
};

}  // namespace wheelwright
