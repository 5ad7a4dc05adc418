#include "model/gap/parameter_intervals.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace wheelwright::gap {
namespace {

constexpr double block_s = 3.0;
constexpr double two_sided_95 = 1.96;

// A pseudo-inverse: directions of which nothing is known stay out.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& information) {
  Eigen::VectorXd scale(information.rows());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    scale(i) = information(i, i) > 0.0 ? 1.0 / std::sqrt(information(i, i)) : 0.0;
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  Eigen::VectorXd inverse = solver.eigenvalues();
  for (double& value : inverse) value = value > 1e-10 ? 1.0 / value : 0.0;
  return scale.asDiagonal() * solver.eigenvectors() * inverse.asDiagonal() *
         solver.eigenvectors().transpose() * scale.asDiagonal();
}

}  // namespace

std::vector<ParameterInterval> parameter_intervals(const GapProblem& problem, const GapFit& fit) {
  const Eigen::MatrixXd columns = problem.jacobian(fit.model, fit.residuals);
  std::map<std::pair<std::size_t, std::size_t>, Eigen::VectorXd> blocks;
  const auto& places = problem.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double time_s = problem.runs()[places[i].run].period_s * static_cast<double>(places[i].period);
    auto& sum = blocks[{places[i].run, static_cast<std::size_t>(time_s / block_s)}];
    if (sum.size() == 0) sum = Eigen::VectorXd::Zero(columns.cols());
    sum += fit.residuals[i] * columns.row(static_cast<Eigen::Index>(i)).transpose();
  }
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  for (const auto& [key, sum] : blocks) spread += sum * sum.transpose();
  const Eigen::MatrixXd inverse = inverse_of(columns.transpose() * columns);
  const Eigen::MatrixXd covariance = inverse * spread * inverse;
  std::vector<ParameterInterval> intervals;
  for (std::size_t i = 0; i < fit.model.parameter_count(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double deviation = std::sqrt(std::max(covariance(at, at), inverse(at, at)));
    const double value = fit.model.parameter(i);
    ParameterInterval interval{value - two_sided_95 * deviation, value + two_sided_95 * deviation};
    if (const ParameterInfo* info = fit.model.parameter_info(i)) {
      interval = {std::max(interval.lower, info->lower), std::min(interval.upper, info->upper)};
    }
    intervals.push_back(interval);
  }
  return intervals;
}

}  // namespace wheelwright::gap
