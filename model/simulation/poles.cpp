#include "model/simulation/poles.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

// Eigenvalues of the block of two rows and columns on the diagonal at i, without overflow.
std::complex<double> upper_of_pair(const Eigen::MatrixXd& schur, Eigen::Index i) {
  const double half_difference = 0.5 * (schur(i, i) - schur(i + 1, i + 1));
  const double below = schur(i + 1, i);
  const double above = schur(i, i + 1);
  const double largest = std::max({std::abs(half_difference), std::abs(below), std::abs(above)});
  const double share = half_difference / largest;
  return {schur(i + 1, i + 1) + half_difference,
          largest * std::sqrt(std::abs(share * share + below / largest * (above / largest)))};
}

}  // namespace

std::vector<std::complex<double>> poles(const WheelResponse& response) {
  const auto order = static_cast<Eigen::Index>(response.from_own_past.size());
  std::vector<std::complex<double>> result;
  if (order == 0) return result;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
  for (Eigen::Index i = 0; i < order; ++i) {
    companion(0, i) = response.from_own_past[static_cast<std::size_t>(i)];
  }
  companion.diagonal(-1).setOnes();
  // A companion matrix has Hessenberg's form already; the reduction to it takes long to compile.
  const double scale = std::max(1.0, companion.row(0).cwiseAbs().maxCoeff());
  Eigen::RealSchur<Eigen::MatrixXd> solver(order);
  solver.computeFromHessenberg(companion / scale, companion, false);
  const Eigen::MatrixXd schur = solver.matrixT() * scale;
  for (Eigen::Index i = 0; i < order; ++i) {
    if (i == order - 1 || schur(i + 1, i) == 0.0) {
      result.emplace_back(schur(i, i));
    } else {
      result.push_back(upper_of_pair(schur, i));
      result.push_back(std::conj(result.back()));
      ++i;
    }
  }
  return result;
}

}  // namespace wheelwright
