// The uncertainty of a pose that was driven from the model alone, against drives of robots that the model may
// stand for.
#include "model/uncertainty/pose_uncertainty.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <random>

#include "model/simulation/model_simulation.hpp"
#include "model/simulation/motion_predictor.hpp"
#include "model/simulation/moved_models.hpp"
#include "tests/support/catch.hpp"

namespace wheelwright {
namespace {

// With wheels that are known to be alike.
RobotModel robot() {
  RobotModel model;
  model.linear_part.wheel_base_m = 0.25;
  model.linear_part.left.from_left = {0.0, 0.2, 0.5, 0.3};
  model.linear_part.right.from_right = {0.0, 0.2, 0.5, 0.28};
  model.linear_part.left.from_right = {0.0, 0.0, 0.0, 0.0};
  model.linear_part.right.from_left = {0.0, 0.0, 0.0, 0.0};
  WheelFit fit;
  fit.gain_standard_error = {0.003, 0.0};
  model.left_fit = fit;
  fit.gain_standard_error = {0.0, 0.004};
  model.right_fit = fit;
  EncoderScale scale;
  scale.metres_per_tick = {0.00044, 0.00044};
  scale.relative_standard_error = 0.002;
  model.encoder_scale = scale;
  AddedEffect alike;
  alike.setting = {"wheel_scale_mismatch", "", {0.0}};
  model.effects.push_back(alike);
  return model;
}

RobotModel robot_with_friction() {
  RobotModel model = robot();
  AddedEffect friction;
  friction.setting = {"coulomb_friction", "", {0.012, 0.1}};
  friction.intervals = {{0.009, 0.015}, {0.1, 0.1}};
  model.effects.push_back(friction);
  return model;
}

// A stretch ahead, a curve, a turn in place, and back.
WheelPair command_at(int period) {
  const double t_s = 0.018 * period;
  if (t_s < 5.0) return {0.2, 0.2};
  if (t_s < 9.0) return {0.12, 0.2};
  if (t_s < 11.0) return {-0.1, 0.1};
  if (t_s < 16.0) return {0.18, 0.18};
  return {};
}
constexpr int periods = 950;

Pose driven(const RobotModel& model) {
  ModelSimulation simulation(model);
  for (int k = 0; k < periods; ++k) simulation.step(command_at(k));
  return simulation.pose();
}

Eigen::Matrix3d predicted_covariance(const RobotModel& model) {
  MotionPredictor predictor(model);
  PoseUncertainty uncertainty(model);
  for (int k = 0; k < periods; ++k) {
    predictor.step(command_at(k));
    uncertainty.step(command_at(k), predictor.motion());
  }
  return uncertainty.covariance();
}

void scale_by(std::vector<double>& weights, double factor) {
  for (double& weight : weights) weight *= factor;
}

// One of the robots that the model may stand for.
RobotModel drawn(RobotModel model, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double scale = 1.0 + 0.002 * normal(random);
  const DcGain left = dc_gain(model.linear_part.left);
  const DcGain right = dc_gain(model.linear_part.right);
  scale_by(model.linear_part.left.from_left,
           scale * (1.0 + std::hypot(0.003 / left.from_left, gain_discrepancy) * normal(random)));
  scale_by(model.linear_part.right.from_right,
           scale * (1.0 + std::hypot(0.004 / right.from_right, gain_discrepancy) * normal(random)));
  if (model.effects.size() > 1) model.effects[1].setting.parameters[0] += 0.003 / 1.96 * normal(random);
  return model;
}

// What noise alone does: of the same robot, all of whose parameters are known.
Eigen::Matrix3d noise_covariance(RobotModel model) {
  model.left_fit->gain_standard_error = model.right_fit->gain_standard_error = {};
  model.encoder_scale->relative_standard_error = 0.0;
  for (AddedEffect& effect : model.effects) effect.intervals.clear();
  return predicted_covariance(model);
}

Eigen::Matrix3d scatter(const RobotModel& model, int robots) {
  std::mt19937 random(7);
  const Pose nominal = driven(model);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < robots; ++i) {
    const Pose end = driven(drawn(model, random));
    const Eigen::Vector3d off(end.x_m - nominal.x_m, end.y_m - nominal.y_m,
                              end.theta_rad - nominal.theta_rad);
    sum += off * off.transpose();
  }
  return sum / robots;
}

TEST_CASE("The covariance of a drive is that of the robots that the model may stand for") {
  const bool with_effect = GENERATE(false, true);
  const RobotModel model = with_effect ? robot_with_friction() : robot();
  const Eigen::Matrix3d expected = scatter(model, 8000);
  const Eigen::Matrix3d predicted = predicted_covariance(model) - noise_covariance(model);
  for (int i = 0; i < 3; ++i) {
    CAPTURE(with_effect, i, expected(i, i), predicted(i, i));
    CHECK(predicted(i, i) == Approx(expected(i, i)).epsilon(0.05));
  }
  CHECK(predicted(0, 1) == Approx(expected(0, 1)).epsilon(0.05));
}

TEST_CASE("An uncertain effect adds to the uncertainty of the pose") {
  const double without = predicted_covariance(robot())(2, 2);
  CHECK(predicted_covariance(robot_with_friction())(2, 2) > without);
}

TEST_CASE("Where nobody knows whether the wheels are alike, the pose is less sure") {
  RobotModel model = robot();
  const double alike = predicted_covariance(model)(2, 2);
  model.effects.clear();
  CHECK(predicted_covariance(model)(2, 2) > alike);
}

TEST_CASE("Noise of the wheels grows with the square root of time, and its pose with it") {
  RobotModel model = robot();
  model.left_fit = model.right_fit = std::nullopt;
  model.encoder_scale.reset();
  MotionPredictor predictor(model);
  PoseUncertainty uncertainty(model);
  std::vector<double> heading_variances;
  for (int k = 0; k < 2000; ++k) {
    predictor.step({0.2, 0.2});
    uncertainty.step({0.2, 0.2}, predictor.motion());
    if (k == 999 || k == 1999) heading_variances.push_back(uncertainty.covariance()(2, 2));
  }
  CHECK(heading_variances[1] == Approx(2.0 * heading_variances[0]).epsilon(0.01));
}

TEST_CASE("A robot whose pose is known is sure of it") {
  const RobotModel model = robot();
  MotionPredictor predictor(model);
  PoseUncertainty uncertainty(model);
  for (int k = 0; k < 100; ++k) {
    predictor.step({0.2, 0.1});
    uncertainty.step({0.2, 0.1}, predictor.motion());
  }
  const Pose known{1.0, 2.0, 0.5};
  predictor.set_pose(known);
  uncertainty.set_pose(known);
  CHECK(uncertainty.covariance().norm() == 0.0);
}

TEST_CASE("A model that takes the place of another one keeps what was uncertain") {
  const RobotModel model = robot();
  MotionPredictor predictor(model);
  PoseUncertainty before(model);
  for (int k = 0; k < 300; ++k) {
    predictor.step({0.2, 0.1});
    before.step({0.2, 0.1}, predictor.motion());
  }
  PoseUncertainty after(model);
  after.take_over(before, predictor.pose());
  CHECK(after.covariance().isApprox(before.covariance(), 1e-12));
}

TEST_CASE("Each parameter whose uncertainty is stated moves a model") {
  CHECK(moved_models(robot()).size() == 3);
  CHECK(moved_models(robot_with_friction()).size() == 4);  // an interval without width moves nothing
  CHECK(moved_models(RobotModel{}).empty());
}

TEST_CASE("An interval counts as far as it is physically possible") {
  RobotModel model = robot_with_friction();
  model.effects[1].intervals[0] = {-1.0, 0.013};
  CHECK(moved_models(model).back().down.effects[1].setting.parameters[0] == 0.0);
}

TEST_CASE("The radius of 95 of 100 drives is that of the distribution") {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  SECTION("of a circle") {
    covariance.diagonal() << 4e-4, 4e-4, 0.0;
    CHECK(position_radius95_m(covariance) == Approx(0.02 * std::sqrt(-2.0 * std::log(0.05))).epsilon(2e-3));
  }
  SECTION("of a line") {
    covariance.diagonal() << 4e-4, 0.0, 0.0;
    CHECK(position_radius95_m(covariance) == Approx(0.02 * 1.959964).epsilon(1e-3));
  }
  SECTION("of an ellipse, by drawing") {
    covariance.topLeftCorner<2, 2>() << 4e-4, 1.5e-4, 1.5e-4, 1e-4;
    const double radius_m = position_radius95_m(covariance);
    const Eigen::Matrix2d root = Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()).llt().matrixL();
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
      inside += (root * Eigen::Vector2d(normal(random), normal(random))).norm() < radius_m ? 1 : 0;
    }
    CHECK(inside / 20000.0 == Approx(0.95).margin(0.005));
  }
}

TEST_CASE("The ellipse of a covariance has its axes where the position scatters most and least") {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const double angle = 0.6;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  covariance.topLeftCorner<2, 2>() = turn * Eigen::Vector2d(9e-4, 1e-4).asDiagonal() * turn.transpose();
  const PositionEllipse ellipse = position_ellipse95(covariance);
  CHECK(ellipse.major_m == Approx(0.03 * 2.4477).epsilon(1e-3));
  CHECK(ellipse.minor_m == Approx(0.01 * 2.4477).epsilon(1e-3));
  CHECK(ellipse.direction_rad == Approx(angle));
}

TEST_CASE("Two poses exclude each other beyond twice what both may err") {
  Eigen::Matrix3d narrow = Eigen::Matrix3d::Zero();
  narrow.diagonal() << 0.01 * 0.01, 0.01 * 0.01, 0.0;
  const double radius_m = std::sqrt(2.0) * position_radius95_m(narrow);
  CHECK_FALSE(exclude_each_other({1.0, 0.0, 0.0}, narrow, {1.0, 1.99 * radius_m, 0.0}, narrow));
  CHECK(exclude_each_other({1.0, 0.0, 0.0}, narrow, {1.0, 2.01 * radius_m, 0.0}, narrow));
  CHECK_FALSE(exclude_each_other({1.0, 0.0, 0.0}, 9.0 * narrow, {1.0, 2.01 * radius_m, 0.0}, narrow));
}

}  // namespace
}  // namespace wheelwright
