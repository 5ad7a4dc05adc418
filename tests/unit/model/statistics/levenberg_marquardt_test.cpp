#include "model/statistics/levenberg_marquardt.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

// Residuals as a function of parameters, which must not exceed a bound.
class FunctionFit {
 public:
  using Point = Eigen::VectorXd;

  explicit FunctionFit(Residuals residuals, double largest_parameter = 1e9)
      : residuals_(std::move(residuals)), largest_parameter_(largest_parameter) {}

  double objective(const Point& at) const {
    ++evaluations;
    return residuals_(at).squaredNorm();
  }
  NormalEquations linearise(const Point& at) const {
    const Eigen::VectorXd there = residuals_(at);
    Eigen::MatrixXd slopes(there.size(), at.size());
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      Point moved = at;
      moved[i] += 1e-7;
      slopes.col(i) = (residuals_(moved) - there) / 1e-7;
    }
    return {slopes.transpose() * slopes, slopes.transpose() * there};
  }
  std::optional<Point> moved(const Point& at, const Eigen::VectorXd& step) const {
    const Point there = at + step;
    if (there.maxCoeff() > largest_parameter_) return std::nullopt;
    return there;
  }

  mutable int evaluations = 0;

 private:
  Residuals residuals_;
  double largest_parameter_;
};

Eigen::VectorXd rosenbrock(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]);
}

}  // namespace

TEST_CASE("Levenberg-Marquardt follows Rosenbrock's bent valley to its end") {
  const FunctionFit fit(rosenbrock);
  const Eigen::VectorXd found = levenberg_marquardt(fit, Eigen::Vector2d(-1.2, 1.0), {.max_steps = 100});
  CHECK_THAT(found[0], WithinAbs(1.0, 1e-4));
  CHECK_THAT(found[1], WithinAbs(1.0, 1e-4));
}

TEST_CASE("A linear problem is solved by one step, as by the normal equations") {
  const Eigen::MatrixXd matrix{{1.0, 2.0}, {3.0, 4.0}, {5.0, 7.0}};
  const Eigen::VectorXd right = Eigen::Vector3d(1.0, -1.0, 2.0);
  const FunctionFit fit([&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x - right; });
  const Eigen::VectorXd found =
      levenberg_marquardt(fit, Eigen::Vector2d(9.0, 9.0), {.max_steps = 1, .first_damping = 0.0});
  const Eigen::VectorXd direct = (matrix.transpose() * matrix).ldlt().solve(matrix.transpose() * right);
  CHECK_THAT((found - direct).norm(), WithinAbs(0.0, 1e-5));
}

TEST_CASE("A parameter that no residual feels stays where it was") {
  const FunctionFit fit([](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::Vector2d(x[0] - 3.0, 0.5 * (x[0] - 3.0));
  });
  const Eigen::VectorXd found = levenberg_marquardt(fit, Eigen::Vector2d(0.0, 7.0), {});
  CHECK_THAT(found[0], WithinAbs(3.0, 1e-6));
  CHECK(found[1] == 7.0);
}

TEST_CASE("Where a step is not allowed, a shorter one is taken") {
  // The least sum of squares lies at 5, beyond the bound.
  const FunctionFit fit(
      [](const Eigen::VectorXd& x) -> Eigen::VectorXd { return Eigen::VectorXd::Constant(1, x[0] - 5.0); },
      4.0);
  const Eigen::VectorXd found =
      levenberg_marquardt(fit, Eigen::VectorXd::Constant(1, 0.0), {.max_steps = 40});
  CHECK(found[0] <= 4.0);
  CHECK(found[0] > 3.0);
}

TEST_CASE("A search that starts at an exact solution ends there at once") {
  const FunctionFit fit(rosenbrock);
  const Eigen::VectorXd found = levenberg_marquardt(fit, Eigen::Vector2d(1.0, 1.0), {.max_steps = 1000});
  CHECK(found == Eigen::Vector2d(1.0, 1.0));
  CHECK(fit.evaluations < 20);
}
