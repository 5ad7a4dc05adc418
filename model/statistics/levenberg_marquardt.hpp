// Least squares that are not linear, by the method of Levenberg (1944) and Marquardt (1963).
//
// With residuals r(x) and their derivatives J, each step solves
//
//   (J'J + damping * diag(J'J)) step = -J'r
//
// and is taken where the sum of squares falls. Then the damping falls, too; else it grows and the step is
// tried again, shorter and closer to the steepest descent.
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright {

struct LevenbergMarquardtRule {
  int max_steps = 12;
  int max_attempts = 6;  // dampings that are tried for one step
  double first_damping = 1e-3;
  double min_damping = 0.0;
  double decrease = 0.1;  // of the damping, by a step that is taken
  double increase = 10.0;
  // The search ends where a step lowers the objective by no more than min_fall + min_relative_fall *
  // objective.
  double min_fall = 0.0;
  double min_relative_fall = 1e-5;
};

// J'J and J'r at one point; of a prior, its information and its gradient are added to them.
class NormalEquations {
 public:
  NormalEquations() = default;
  NormalEquations(Eigen::MatrixXd information, Eigen::VectorXd gradient)
      : information_(std::move(information)), gradient_(std::move(gradient)) {}

  const Eigen::MatrixXd& information() const { return information_; }

  // A parameter of which nothing is known stays where it is.
  Eigen::VectorXd step(double damping) const {
    Eigen::MatrixXd damped = information_;
    for (Eigen::Index i = 0; i < damped.rows(); ++i)
      damped(i, i) += damping * (information_(i, i) > 0.0 ? information_(i, i) : 1.0);
    return -solve_symmetric(damped, gradient_);
  }

 private:
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

// A point is a set of parameters, with what has been computed there. `linearise` returns what has a
// `step(damping)`, as NormalEquations has; `moved` nothing where no point is allowed.
template <typename Problem>
concept LeastSquaresProblem = requires(const Problem& problem, const typename Problem::Point& point,
                                       const Eigen::VectorXd& step) {
  { problem.objective(point) } -> std::convertible_to<double>;
  { problem.linearise(point).step(1.0) } -> std::convertible_to<Eigen::VectorXd>;
  { problem.moved(point, step) } -> std::same_as<std::optional<typename Problem::Point>>;
};

template <LeastSquaresProblem Problem>
typename Problem::Point levenberg_marquardt(const Problem& problem, typename Problem::Point point,
                                            const LevenbergMarquardtRule& rule) {
  double damping = rule.first_damping;
  for (int step = 0; step < rule.max_steps; ++step) {
    const auto linearised = problem.linearise(point);
    const double before = problem.objective(point);
    for (int attempt = 0; attempt < rule.max_attempts; ++attempt) {
      auto candidate = problem.moved(point, linearised.step(damping));
      if (candidate && problem.objective(*candidate) < before) {
        point = std::move(*candidate);
        damping = std::max(rule.min_damping, rule.decrease * damping);
        break;
      }
      damping *= rule.increase;
    }
    if (before - problem.objective(point) <= rule.min_fall + rule.min_relative_fall * before) break;
  }
  return point;
}

}  // namespace wheelwright
