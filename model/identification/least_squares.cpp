#include "model/identification/least_squares.hpp"

#include <cmath>

namespace wheelwright {

LeastSquaresAccumulator::LeastSquaresAccumulator(Eigen::Index unknowns, Eigen::Index outputs)
    : unknowns_(unknowns),
      outputs_(outputs),
      triangle_(Eigen::MatrixXd::Zero(unknowns + outputs, unknowns + outputs)),
      block_(Block::Zero(block_rows, unknowns + outputs)) {}

void LeastSquaresAccumulator::add_row(const Eigen::Ref<const Eigen::RowVectorXd>& regressors,
                                      const Eigen::Ref<const Eigen::RowVectorXd>& targets) {
  if (pending_ == block_rows) fold();
  block_.row(pending_).head(unknowns_) = regressors;
  block_.row(pending_).tail(outputs_) = targets;
  ++pending_;
  ++rows_;
}

// One Householder reflection per column. Above the block it touches a single row of the triangle, because
// the rest of that column is zero already.
void LeastSquaresAccumulator::fold() {
  if (pending_ == 0) return;
  const Eigen::Index width = unknowns_ + outputs_;
  for (Eigen::Index j = 0; j < width; ++j) {
    const double below = block_.col(j).squaredNorm();
    if (below == 0.0) continue;
    // The reflection is I - scale [1; v] [1; v]^T and maps column j onto `diagonal` alone.
    const double old = triangle_(j, j);
    const double diagonal = -std::copysign(std::sqrt(old * old + below), old);
    const double scale = (diagonal - old) / diagonal;
    block_.col(j) /= old - diagonal;
    triangle_(j, j) = diagonal;
    for (Eigen::Index c = j + 1; c < width; ++c) {
      const double share = scale * (triangle_(j, c) + block_.col(j).dot(block_.col(c)));
      triangle_(j, c) -= share;
      block_.col(c) -= share * block_.col(j);
    }
  }
  block_.setZero();
  pending_ = 0;
}

LeastSquaresAccumulator::Factor LeastSquaresAccumulator::factor() {
  fold();
  Factor result;
  result.r = triangle_.topLeftCorner(unknowns_, unknowns_);
  result.z = triangle_.topRightCorner(unknowns_, outputs_);
  result.residual_square_sum = triangle_.bottomRightCorner(outputs_, outputs_).colwise().squaredNorm();
  result.rows = rows_;
  return result;
}

}  // namespace wheelwright
