#include "model/gap/fit/likelihood_roughness.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>
#include <vector>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr int pairs = 8;
constexpr double standard_deviations = 0.3;  // near enough that the parabola itself rises by little
constexpr std::uint64_t seed_of_steps = 1;
constexpr double lowest = 0.25;  // share of the places: what a fit that starts there would go down to

Eigen::VectorXd parameters_of(const TrialModel& model) {
  return Eigen::VectorXd::NullaryExpr(
      static_cast<Eigen::Index>(model.parameter_count()),
      [&](Eigen::Index i) { return model.parameter(static_cast<std::size_t>(i)); });
}

}  // namespace

double likelihood_roughness(const FitProblem& problem, const Fit& fit, const Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd information = columns.transpose() * columns;
  const Eigen::Map<const Eigen::VectorXd> residuals(fit.residuals.data(), columns.rows());
  const Eigen::VectorXd gradient = columns.transpose() * residuals;
  Eigen::MatrixXd with_sizes = information;
  for (Eigen::Index i = 0; i < with_sizes.rows(); ++i) {
    const double size = typical_size(fit.model, static_cast<std::size_t>(i));
    with_sizes(i, i) += 1.0 / (size * size);
  }
  // How far one without a slope may be moved, nothing here tells.
  const Eigen::ArrayX<bool> has_slope = information.diagonal().array() > 0.0;
  const Eigen::LLT<Eigen::MatrixXd> factor(with_sizes);
  std::mt19937_64 random(seed_of_steps);
  std::normal_distribution<double> normal;
  std::vector<double> beyond_parabola;
  for (int pair = 0; pair < pairs; ++pair) {
    const Eigen::VectorXd direction =
        Eigen::VectorXd::NullaryExpr(with_sizes.rows(), [&] { return normal(random); });
    Eigen::VectorXd step = standard_deviations * factor.matrixU().solve(direction);
    step = has_slope.select(step.array(), 0.0).matrix();
    for (const double side : {1.0, -1.0}) {
      const TrialModel model = fit.model.moved(side * step);
      if (!model.stable()) continue;
      const Eigen::VectorXd by = parameters_of(model) - parameters_of(fit.model);  // within bounds
      const double rise = sum_squares_of(problem.residuals(model)) - fit.sum_squares;
      beyond_parabola.push_back(rise - 2.0 * gradient.dot(by) - by.dot(information * by));
    }
  }
  return beyond_parabola.empty() ? 0.0 : std::max(0.0, quantile(beyond_parabola, lowest));
}

}  // namespace wheelwright::gap
