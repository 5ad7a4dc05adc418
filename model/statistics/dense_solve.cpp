#include "model/statistics/dense_solve.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace wheelwright {

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side) {
  return matrix.ldlt().solve(right_side);
}

Eigen::MatrixXd solve_symmetric_columns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right_sides) {
  return matrix.ldlt().solve(right_sides);
}

std::optional<Eigen::VectorXd> solve_positive(const Eigen::MatrixXd& matrix,
                                              const Eigen::VectorXd& right_side) {
  const Eigen::LDLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success || !factor.isPositive()) return std::nullopt;
  return factor.solve(right_side);
}

Eigen::VectorXd solve_by_qr(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side) {
  return matrix.colPivHouseholderQr().solve(right_side);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

Eigen::MatrixXd rest_beside(const Eigen::MatrixXd& left_out, const Eigen::MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(left_out);
  Eigen::MatrixXd turned = columns;
  turned.applyOnTheLeft(qr.householderQ().setLength(qr.nonzeroPivots()).transpose());
  return turned.bottomRows(turned.rows() - qr.rank());
}

}  // namespace wheelwright
