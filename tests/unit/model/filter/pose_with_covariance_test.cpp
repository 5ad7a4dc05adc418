#include "model/filter/pose_with_covariance.hpp"

#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double wheel_base_m = 0.235;

// A closed way of arcs to both sides, in steps of a centimetre.
WheelPair step_m(int step) {
  const double turn_m = step % 300 < 200 ? 0.0015 : -0.001;
  return {0.01 - turn_m, 0.01 + turn_m};
}
constexpr int steps = 900;

PoseWithCovariance stated(double mismatch) {
  PoseWithCovariance pose(wheel_base_m, {.scale = 0.0, .wheel_mismatch = mismatch});
  pose.reset({});
  for (int step = 0; step < steps; ++step) pose.move(step_m(step), {1e-9, 1e-9, 0.0});
  return pose;
}

Pose driven(double mismatch) {
  Pose pose;
  for (int step = 0; step < steps; ++step) {
    const WheelPair rolled_m = step_m(step);
    const WheelPair on_floor_m{(1.0 - 0.5 * mismatch) * rolled_m.left,
                               (1.0 + 0.5 * mismatch) * rolled_m.right};
    pose = move_along_arc(pose, twist_of_wheels(on_floor_m, wheel_base_m), 1.0);
  }
  return pose;
}

}  // namespace

TEST_CASE("The ellipse of wheels that may differ is as wide as their ends scatter, across it too") {
  constexpr double mismatch = 0.005;
  const PoseWithCovariance pose = stated(mismatch);
  std::mt19937 engine(1);
  std::normal_distribution<double> normal(0.0, mismatch);
  constexpr int draws = 4000;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (int draw = 0; draw < draws; ++draw) {
    const Pose end = driven(normal(engine));
    const Eigen::Vector2d off(end.x_m - pose.pose().x_m, end.y_m - pose.pose().y_m);
    scatter += off * off.transpose() / draws;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  REQUIRE(std::sqrt(axes.eigenvalues()(0)) > 0.003);  // the way bends: across is no line
  const Eigen::Matrix2d covariance = pose.covariance().topLeftCorner<2, 2>();
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d along = axes.eigenvectors().col(axis);
    CHECK_THAT(std::sqrt(along.dot(covariance * along)),
               WithinRel(std::sqrt(axes.eigenvalues()(axis)), axis == 0 ? 0.3 : 0.1));
  }
}

TEST_CASE("Wheels that are surely alike leave no doubt but noise") {
  const Eigen::Matrix3d covariance = stated(0.0).covariance();
  CHECK(std::sqrt(covariance(0, 0)) < 0.02);
}
