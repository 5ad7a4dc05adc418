// Dense linear systems A x = b of a size that is known at run time. Each of Eigen's decompositions takes
// seconds to compile: here they are compiled once.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace wheelwright {

// A symmetric and not negative, n x n, by L D L' with pivots; a direction of which A says nothing gets 0.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side);
// The same for each column of B, n x m.
Eigen::MatrixXd solve_symmetric_columns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right_sides);
// The same; nothing where a pivot is negative or A is not finite.
std::optional<Eigen::VectorXd> solve_positive(const Eigen::MatrixXd& matrix,
                                              const Eigen::VectorXd& right_side);

// Any A, m x n with m >= n, by Householder's QR with column pivots: least squares where m > n.
Eigen::VectorXd solve_by_qr(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side);
// An orthonormal basis, m x rank, of the space that the columns span.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);
// What of each column no sum of `left_out`'s columns makes, in a basis of that rest: (m - rank) x columns.
Eigen::MatrixXd rest_beside(const Eigen::MatrixXd& left_out, const Eigen::MatrixXd& columns);

}  // namespace wheelwright
