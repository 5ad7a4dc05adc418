#include "model/filter/pose_with_covariance.hpp"

#include <cmath>

namespace wheelwright {

void PoseWithCovariance::move(const WheelPair& rolled_m, const TravelVariance& variance,
                              const Twist& beyond) {
  Twist moved = twist_of_wheels(rolled_m, wheel_base_m_);
  moved.v_m_s += beyond.v_m_s;
  moved.w_rad_s += beyond.w_rad_s;
  const double direction = pose_.theta_rad + 0.5 * moved.w_rad_s;
  const double c = std::cos(direction);
  const double s = std::sin(direction);

  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose(0, 2) = -moved.v_m_s * s;
  by_pose(1, 2) = moved.v_m_s * c;
  Eigen::Matrix<double, 3, 2> by_motion;  // of forward way and turn
  by_motion << c, -0.5 * moved.v_m_s * s, s, 0.5 * moved.v_m_s * c, 0.0, 1.0;

  const double sum_m2 = variance.left_m2 + variance.right_m2;
  const double scale2 = scale_standard_error_ * scale_standard_error_;
  const double way_m = std::abs(moved.v_m_s);
  const double turn_rad = moved.w_rad_s;
  Eigen::Matrix2d motion;
  motion(0, 0) = 0.25 * sum_m2 + scale2 * (way_m * way_m + 2.0 * way_m * way_m_);
  // Turns to both sides cancel the error of the scale, so the variance of the heading may shrink again.
  motion(1, 1) = sum_m2 / (wheel_base_m_ * wheel_base_m_) +
                 std::max(0.0, scale2 * (turn_rad * turn_rad + 2.0 * turn_rad * turned_rad_));
  motion(0, 1) = motion(1, 0) = 0.5 * (variance.right_m2 - variance.left_m2) / wheel_base_m_;
  covariance_ = by_pose * covariance_ * by_pose.transpose() + by_motion * motion * by_motion.transpose();
  way_m_ += way_m;
  turned_rad_ += turn_rad;
  pose_ = move_along_arc(pose_, moved, 1.0);
}

void PoseWithCovariance::reset(const Pose& pose) {
  pose_ = pose;
  covariance_.setZero();
  way_m_ = 0.0;
  turned_rad_ = 0.0;
}

}  // namespace wheelwright
