#include "model/identification/least_squares_solution.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

namespace wheelwright {
namespace {

// The triangle is square and has some ten to a hundred columns: Jacobi's method is exact to the last digits,
// and quick both to run and to compile.
using Svd = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>;

// Factors that bring all columns to equal size.
Eigen::VectorXd equal_sizes(const Eigen::MatrixXd& r) {
  Eigen::VectorXd scale = r.colwise().norm();
  for (double& size : scale) size = size > 0.0 ? 1.0 / size : 1.0;
  return scale;
}

}  // namespace

SmallSolution solve_small(const LeastSquaresAccumulator::Factor& factor, Eigen::Index output) {
  const Eigen::VectorXd scale = equal_sizes(factor.r);
  const Svd svd(factor.r * scale.asDiagonal(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& singular = svd.singularValues();
  SmallSolution result;
  result.rank = (singular.array() > rank_tolerance * singular[0]).count();
  const double smallest = singular[singular.size() - 1];
  result.condition = smallest > 0.0 ? singular[0] / smallest : std::numeric_limits<double>::infinity();

  const Eigen::MatrixXd seen = scale.asDiagonal() * svd.matrixV().leftCols(result.rank) *
                               singular.head(result.rank).cwiseInverse().asDiagonal();
  const Eigen::VectorXd image = svd.matrixU().leftCols(result.rank).transpose() * factor.z.col(output);
  result.unknowns = seen * image;
  const Eigen::Index freedom = std::max<Eigen::Index>(1, factor.rows - result.rank);
  const double unseen = std::max(0.0, factor.z.col(output).squaredNorm() - image.squaredNorm());
  result.residual_variance =
      (factor.residual_square_sum[output] + (result.rank < singular.size() ? unseen : 0.0)) /
      static_cast<double>(freedom);
  result.covariance = result.residual_variance * seen * seen.transpose();
  result.deviations = result.covariance.diagonal().cwiseSqrt();
  return result;
}

Eigen::VectorXd solve_quickly(const LeastSquaresAccumulator::Factor& factor, Eigen::Index output) {
  const Eigen::VectorXd scale = equal_sizes(factor.r);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(factor.r * scale.asDiagonal());
  qr.setThreshold(rank_tolerance);
  return scale.asDiagonal() * qr.solve(factor.z.col(output));
}

DampedSteps::DampedSteps(const LeastSquaresAccumulator::Factor& factor) : scale_(equal_sizes(factor.r)) {
  const Svd svd(factor.r * scale_.asDiagonal(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  singular_ = svd.singularValues();
  v_ = svd.matrixV();
  image_ = svd.matrixU().transpose() * factor.z.col(0);
}

Eigen::VectorXd DampedSteps::step(double damping) const {
  const double largest = singular_[0];
  Eigen::VectorXd along = Eigen::VectorXd::Zero(singular_.size());
  for (Eigen::Index i = 0; i < singular_.size(); ++i) {
    if (singular_[i] <= rank_tolerance * largest) break;
    along[i] = singular_[i] * image_[i] / (singular_[i] * singular_[i] + damping * largest * largest);
  }
  return scale_.asDiagonal() * (v_ * along);
}

double residual_square_sum(const LeastSquaresAccumulator::Factor& factor, const Eigen::VectorXd& unknowns,
                           Eigen::Index output) {
  return factor.residual_square_sum[output] + (factor.r * unknowns - factor.z.col(output)).squaredNorm();
}

}  // namespace wheelwright
