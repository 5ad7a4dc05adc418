// Linear least squares over any number of rows in the memory of one small triangle.
//
// Rows arrive in blocks; a QR factorisation of the triangle so far stacked on the new block keeps
//     [ R  z ]      with   ||A x - y||^2 = ||R x - z||^2 + residual.
//     [ 0  e ]
// Orthogonal transformations keep the condition of A, where the normal equations would square it. Adding a
// row costs about 2 (unknowns + outputs)^2 operations on average, and allocates nothing.
#pragma once

#include <Eigen/Core>

namespace wheelwright {

class LeastSquaresAccumulator {
 public:
  // `unknowns` columns of A, `outputs` right-hand sides that share A.
  LeastSquaresAccumulator(Eigen::Index unknowns, Eigen::Index outputs);

  // Adds one equation per output: regressors . x = targets.
  void add_row(const Eigen::Ref<const Eigen::RowVectorXd>& regressors,
               const Eigen::Ref<const Eigen::RowVectorXd>& targets);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index unknowns() const { return unknowns_; }

  // The small problem that has the same solutions; what has been added so far is folded in.
  struct Factor {
    Eigen::MatrixXd r;                    // unknowns x unknowns, upper triangular
    Eigen::MatrixXd z;                    // unknowns x outputs
    Eigen::VectorXd residual_square_sum;  // one per output, of the unregularised solution
    Eigen::Index rows = 0;                // how many equations went in
  };
  Factor factor();

 private:
  // A multiple of four; at order 9 the block just stays in the first-level cache.
  static constexpr Eigen::Index block_rows = 128;
  using Block = Eigen::Matrix<double, block_rows, Eigen::Dynamic>;

  void fold();

  Eigen::Index unknowns_;
  Eigen::Index outputs_;
  Eigen::Index rows_ = 0;
  Eigen::Index pending_ = 0;
  Eigen::MatrixXd triangle_;
  Block block_;  // new rows; zero below the pending ones
};

}  // namespace wheelwright
