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
  by_scale_ = by_pose * by_scale_ + by_travel * scaled;
  pose_ = move_along_arc(pose_, moved, 1.0);
  for (const double sign : {1.0, -1.0}) {
    const double half = sign * 0.5 * systematic_.wheel_mismatch;
    Twist unequal =
        twist_of_wheels({(1.0 - half) * rolled_m.left, (1.0 + half) * rolled_m.right}, wheel_base_m_);
    unequal.v_m_s += beyond.v_m_s;
    unequal.w_rad_s += beyond.w_rad_s;
    Pose& end = by_mismatch_.at(sign > 0.0 ? 0 : 1);
    end = move_along_arc(end, unequal, 1.0);
  }
}

void PoseWithCovariance::reset(const Pose& pose, const Eigen::Matrix3d& covariance) {
  pose_ = pose;
  noise_ = covariance;
  by_scale_.setZero();
  by_mismatch_.fill(pose);
}

Eigen::Matrix3d PoseWithCovariance::covariance() const {
  const auto off_by = [this](const Pose& end) {
    return Eigen::Vector3d(end.x_m - pose_.x_m, end.y_m - pose_.y_m, end.theta_rad - pose_.theta_rad);
  };
  const Eigen::Vector3d one = off_by(by_mismatch_[0]);
  const Eigen::Vector3d other = off_by(by_mismatch_[1]);
  const Eigen::Vector3d straight = 0.5 * (one - other);
  const Eigen::Vector3d bent = 0.5 * (one + other);
  return noise_ + by_scale_ * by_scale_.transpose() + straight * straight.transpose() +
         3.0 * bent * bent.transpose();
}

}  // namespace wheelwright
