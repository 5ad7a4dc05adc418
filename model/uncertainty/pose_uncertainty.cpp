#include "model/uncertainty/pose_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/simulation/moved_models.hpp"

namespace wheelwright {
namespace {

Eigen::Vector3d difference(const Pose& to, const Pose& from) {
  return {to.x_m - from.x_m, to.y_m - from.y_m, wrap_angle(to.theta_rad - from.theta_rad)};
}

// Variances along the axes of the ellipse, the larger one first.
struct PrincipalVariances {
  double major_m2;
  double minor_m2;
};

PrincipalVariances principal_variances(const Eigen::Matrix3d& covariance) {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  const double radius = std::hypot(half_difference, covariance(0, 1));
  return {mean + radius, std::max(0.0, mean - radius)};
}

}  // namespace

PoseUncertainty::PoseUncertainty(const RobotModel& model)
    : period_s_(model.linear_part.period_s),
      noise_(filter_noise_of(model)),
      with_noise_(model.linear_part.wheel_base_m, {.scale = 0.0, .wheel_mismatch = noise_.wheel_mismatch}) {
  for (const MovedModels& moved : moved_models(model))
    moved_.push_back({ModelSimulation(moved.up), ModelSimulation(moved.down)});
}

void PoseUncertainty::step(const WheelPair& command_m_s, const ModelSimulation::Motion& motion) {
  for (Moved& moved : moved_) {
    moved.up.step(command_m_s);
    moved.down.step(command_m_s);
  }
  const WheelPair& floor_m_s = motion.floor_m_s;
  const WheelPair rolled_m{floor_m_s.left * period_s_, floor_m_s.right * period_s_};
  const Twist by_wheels = twist_of_wheels(floor_m_s, with_noise_.wheel_base_m());
  const Twist beyond{(motion.twist.v_m_s - by_wheels.v_m_s) * period_s_,
                     (motion.twist.w_rad_s - by_wheels.w_rad_s) * period_s_};
  with_noise_.move(rolled_m, noise_of(command_m_s, floor_m_s), beyond);
  command_m_s_ = command_m_s;
}

TravelVariance PoseUncertainty::noise_of(const WheelPair& command_m_s, const WheelPair& floor_m_s) const {
  const double slip_m2_per_m = noise_.slip_m_per_sqrt_m * noise_.slip_m_per_sqrt_m;
  const double moment_s2 = noise_.refresh_period_s * noise_.refresh_period_s / 12.0;
  const WheelPair change{command_m_s.left - command_m_s_.left, command_m_s.right - command_m_s_.right};
  const auto variance = [&](double drift, double speed_m_s, double changed) {
    return (drift * drift + slip_m2_per_m * std::abs(speed_m_s)) * period_s_ + moment_s2 * changed * changed;
  };
  return {variance(noise_.drift_m_per_sqrt_s.left, floor_m_s.left, change.left),
          variance(noise_.drift_m_per_sqrt_s.right, floor_m_s.right, change.right),
          moment_s2 * change.left * change.right};
}

void PoseUncertainty::reset(const Pose& pose) {
  for (Moved& moved : moved_) {
    moved.up.reset(pose);
    moved.down.reset(pose);
  }
  with_noise_.reset(pose);
  command_m_s_ = {};
}

void PoseUncertainty::set_pose(const Pose& pose) {
  for (Moved& moved : moved_) {
    moved.up.set_pose(pose);
    moved.down.set_pose(pose);
  }
  with_noise_.reset(pose);
}

void PoseUncertainty::take_over(const PoseUncertainty& before, const Pose& pose) {
  const Eigen::Matrix3d covariance = before.covariance();
  set_pose(pose);
  with_noise_.reset(pose, covariance);
}

Eigen::Matrix3d PoseUncertainty::covariance() const {
  Eigen::Matrix3d sum = with_noise_.covariance();
  for (const Moved& moved : moved_) {
    const Eigen::Vector3d off = 0.5 * difference(moved.up.pose(), moved.down.pose());
    sum += off * off.transpose();
  }
  return sum;
}

PositionEllipse position_ellipse95(const Eigen::Matrix3d& covariance) {
  const PrincipalVariances variances = principal_variances(covariance);
  return {std::sqrt(chi_square95_of_two * variances.major_m2),
          std::sqrt(chi_square95_of_two * variances.minor_m2),
          0.5 * std::atan2(2.0 * covariance(0, 1), covariance(0, 0) - covariance(1, 1))};
}

std::vector<Pose> ellipse95_outline(const Pose& pose, const Eigen::Matrix3d& covariance, int corners) {
  const PositionEllipse ellipse = position_ellipse95(covariance);
  const Pose middle{pose.x_m, pose.y_m, ellipse.direction_rad};
  std::vector<Pose> outline;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    outline.push_back(
        compose(middle, {ellipse.major_m * std::cos(angle), ellipse.minor_m * std::sin(angle), 0.0}));
  }
  return outline;
}

double position_radius95_m(const Eigen::Matrix3d& covariance) {
  const PrincipalVariances variances = principal_variances(covariance);
  if (variances.major_m2 <= 0.0) return 0.0;
  const double ratio = std::sqrt(variances.minor_m2 / variances.major_m2);
  const double factor = 1.96079 + ratio * (0.004071 + ratio * (0.114276 + ratio * 0.371625));
  return factor * std::sqrt(variances.major_m2);
}

bool exclude_each_other(const Pose& one, const Eigen::Matrix3d& covariance_of_one, const Pose& other,
                        const Eigen::Matrix3d& covariance_of_other) {
  constexpr double far = 2.0;
  const double radius_m =
      std::hypot(position_radius95_m(covariance_of_one), position_radius95_m(covariance_of_other));
  return distance_between_m(one, other) > far * radius_m;
}

}  // namespace wheelwright
