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
  Eigen::Matrix<double, 3, 2> by_travel;  // of the left and the right wheel
  const double by_turn = 0.5 * moved.v_m_s / wheel_base_m_;
  by_travel << 0.5 * c + by_turn * s, 0.5 * c - by_turn * s,  //
      0.5 * s - by_turn * c, 0.5 * s + by_turn * c,           //
      -1.0 / wheel_base_m_, 1.0 / wheel_base_m_;

  Eigen::Matrix2d travel;
  travel << variance.left_m2, variance.both_m2, variance.both_m2, variance.right_m2;
  noise_ = by_pose * noise_ * by_pose.transpose() + by_travel * travel * by_travel.transpose();
  const Eigen::Vector2d scaled(systematic_.scale * rolled_m.left, systematic_.scale * rolled_m.right);
  const double half = 0.5 * systematic_.wheel_mismatch;
  const Eigen::Vector2d unequal(-half * rolled_m.left, half * rolled_m.right);
  systematic_offsets_[0] = by_pose * systematic_offsets_[0] + by_travel * scaled;
  systematic_offsets_[1] = by_pose * systematic_offsets_[1] + by_travel * unequal;
  pose_ = move_along_arc(pose_, moved, 1.0);
}

void PoseWithCovariance::reset(const Pose& pose, const Eigen::Matrix3d& covariance) {
  pose_ = pose;
  noise_ = covariance;
  systematic_offsets_.fill(Eigen::Vector3d::Zero());
}

Eigen::Matrix3d PoseWithCovariance::covariance() const {
  Eigen::Matrix3d sum = noise_;
  for (const Eigen::Vector3d& offset : systematic_offsets_) sum += offset * offset.transpose();
  return sum;
}

}  // namespace wheelwright
