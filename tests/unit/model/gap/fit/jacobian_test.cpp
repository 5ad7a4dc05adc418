// Derivatives of what a model leaves, and what a fit makes of them.
#include <cmath>

#include "model/gap/fit/fit_problem.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using test::Counts;
using test::robot_with;
using test::seen_drive;

namespace {

WheelPair jumps_m_s(double t_s) {
  const auto jump_m_s = [](double time_s) { return 0.25 * std::sin(2.0 * std::floor(1.5 * time_s)); };
  return {jump_m_s(t_s), 0.8 * jump_m_s(t_s + 0.4)};
}

// What residuals change by where the wheels' gains and lags grow, for a unit of it.
Eigen::VectorXd change_with_wheels(const FitProblem& problem, const TrialModel& model) {
  constexpr double share = 1e-5;
  const auto there = [&](double by) {
    TrialModel moved = model;
    for (std::size_t i = 0; i < model.shape.of_wheels(); ++i)
      moved.set_parameter(i, (1.0 + by) * model.parameter(i));
    const std::vector<double> residuals = problem.residuals(moved);
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(residuals.data(), std::ssize(residuals)));
  };
  return (there(share) - there(-share)) / (2.0 * share);
}

}  // namespace

TEST_CASE("Derivatives by how wheels move hold for poses, whatever makes motion of the wheels' travel") {
  const auto robot =
      GENERATE(robot_with("direction_gain", {-0.05}), robot_with("acceleration_slip", {0.4, 0.5}),
               robot_with("effective_track", {0.03}), robot_with("yaw_bias", {0.02}),
               robot_with("lever_arm", {0.05, 0.02}));
  INFO(robot.effects.front().info->name);
  const Counts counts = GENERATE(Counts::none, Counts::of_wheels);
  const FitProblem problem = seen_drive(robot, 1500, jumps_m_s, counts);
  const Eigen::MatrixXd columns = problem.jacobian(robot, problem.residuals(robot));
  Eigen::VectorXd by_slopes = Eigen::VectorXd::Zero(columns.rows());
  for (std::size_t i = 0; i < robot.shape.of_wheels(); ++i)
    by_slopes += robot.parameter(i) * columns.col(static_cast<Eigen::Index>(i));
  constexpr double rounding = 1e-9;  // where nothing changes
  const Eigen::VectorXd change = change_with_wheels(problem, robot);
  for (const auto channel : {Channel::left, Channel::forward, Channel::aside, Channel::turn}) {
    double square = 0.0;
    double error = 0.0;
    for (Eigen::Index i = 0; i < change.size(); ++i) {
      if (problem.indices()[static_cast<std::size_t>(i)].channel != channel) continue;
      square += change(i) * change(i);
      error += std::pow(by_slopes(i) - change(i), 2);
    }
    INFO(static_cast<int>(channel));
    CHECK(error <= 1e-6 * square + rounding);
  }
}

TEST_CASE("A fit with slip on the floor is as likely as the robot itself") {
  // Poses show how the wheels speed up, as slip depends on it.
  const TrialModel robot = robot_with("acceleration_slip", {0.45, 0.44});
  const FitProblem problem = seen_drive(robot, 3000, jumps_m_s, Counts::of_wheels);
  TrialModel start = robot_with("acceleration_slip", {0.3, 0.6});
  start.linear_part = first_guess({}, 0.02, 0.25, 0.1, 0.02).linear_part;
  const double of_robot = sum_squares_of(problem.residuals(robot));
  CHECK(problem.fit(start, 40).sum_squares < of_robot);
}
