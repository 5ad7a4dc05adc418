// A pose and how sure it is, carried along arcs.
#pragma once

#include <Eigen/Core>

#include "model/geometry/pose.hpp"

namespace wheelwright {

// Variances of one tick's wheel travel, apart from what the scale of both wheels has in common.
struct TravelVariance {
  double left_m2 = 0.0;
  double right_m2 = 0.0;
};

class PoseWithCovariance {
 public:
  // `scale_standard_error` of metres per tick, as a fraction: the same error in every step, so that its
  // variance grows with the square of the way.
  PoseWithCovariance(double wheel_base_m, double scale_standard_error)
      : wheel_base_m_(wheel_base_m), scale_standard_error_(scale_standard_error) {}

  // Both wheels have rolled so far; `beyond` is what the body has moved beyond the wheels' travel (way in m,
  // turn in rad), as slip and geometry have it.
  void move(const WheelPair& rolled_m, const TravelVariance& variance, const Twist& beyond = {});

  // Starts again at a pose that is known.
  void reset(const Pose& pose);

  const Pose& pose() const { return pose_; }
  // Of x, y (m) and theta (rad), in the frame of the pose.
  const Eigen::Matrix3d& covariance() const { return covariance_; }

 private:
  double wheel_base_m_;
  double scale_standard_error_;
  double way_m_ = 0.0;
  double turned_rad_ = 0.0;
  Pose pose_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
};

}  // namespace wheelwright
