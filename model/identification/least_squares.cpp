#include "model/identification/least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace wheelwright {
namespace {

constexpr Eigen::Index block_rows = 128;

}  // namespace

LeastSquaresAccumulator::LeastSquaresAccumulator(Eigen::Index unknowns, Eigen::Index outputs)
    : unknowns_(unknowns),
      outputs_(outputs),
      stack_(Eigen::MatrixXd::Zero(unknowns + outputs + block_rows, unknowns + outputs)) {}

void LeastSquaresAccumulator::add_row(const Eigen::Ref<const Eigen::RowVectorXd>& regressors,
                                      const Eigen::Ref<const Eigen::RowVectorXd>& targets) {
  if (pending_ == block_rows) fold();
  const Eigen::Index row = unknowns_ + outputs_ + pending_;
  stack_.row(row).head(unknowns_) = regressors;
  stack_.row(row).tail(outputs_) = targets;
  ++pending_;
  ++rows_;
}

void LeastSquaresAccumulator::fold() {
  if (pending_ == 0) return;
  const Eigen::Index width = unknowns_ + outputs_;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(stack_.topRows(width + pending_));
  stack_.topRows(width) = qr.matrixQR().topRows(width).triangularView<Eigen::Upper>();
  stack_.bottomRows(block_rows).setZero();
  pending_ = 0;
}

LeastSquaresAccumulator::Factor LeastSquaresAccumulator::factor() {
  fold();
  Factor result;
  result.r = stack_.topLeftCorner(unknowns_, unknowns_);
  result.z = stack_.topRightCorner(unknowns_, outputs_);
  result.residual_square_sum = stack_.block(unknowns_, unknowns_, outputs_, outputs_).colwise().squaredNorm();
  result.rows = rows_;
  return result;
}

}  // namespace wheelwright
