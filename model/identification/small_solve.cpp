#include "model/identification/small_solve.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>

namespace wheelwright {

SmallSolution solve_small(const LeastSquaresAccumulator::Factor& factor, Eigen::Index output) {
  Eigen::VectorXd scale = factor.r.colwise().norm();
  for (double& size : scale) size = size > 0.0 ? 1.0 / size : 1.0;
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(factor.r * scale.asDiagonal(),
                                           Eigen::ComputeFullU | Eigen::ComputeFullV);
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

double residual_square_sum(const LeastSquaresAccumulator::Factor& factor, const Eigen::VectorXd& unknowns,
                           Eigen::Index output) {
  return factor.residual_square_sum[output] + (factor.r * unknowns - factor.z.col(output)).squaredNorm();
}

}  // namespace wheelwright
