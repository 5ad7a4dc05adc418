#include "model/gap/fit/block_bootstrap.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <vector>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_known = 1e-10;  // of a direction, beside the best known one, in units of each parameter

// The directions of which something is known, as columns, in units in which the information is the identity.
Eigen::MatrixXd known_directions(const Eigen::MatrixXd& information) {
  Eigen::VectorXd scale(information.rows());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    scale(i) = information(i, i) > 0.0 ? 1.0 / std::sqrt(information(i, i)) : 0.0;
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  const Eigen::VectorXd& values = solver.eigenvalues();
  Eigen::Index first = 0;
  while (first < values.size() && values(first) <= min_known) ++first;
  const Eigen::Index known = values.size() - first;
  return scale.asDiagonal() * solver.eigenvectors().rightCols(known) *
         values.tail(known).cwiseSqrt().cwiseInverse().asDiagonal();
}

// Exponential with mean 1, the same on every platform.
double random_weight(std::mt19937_64& random) {
  constexpr double to_unit = 0x1.0p-53;
  return -std::log((static_cast<double>(random() >> 11U) + 0.5) * to_unit);
}

// Random weights scatter by (n - 1) / (n + 1) too little, and quantiles of few blocks are those of Student's
// t, here by the first term of its expansion (Abramowitz and Stegun, 26.7.5) at 95 %.
double small_sample_factor(double blocks) {
  if (blocks < 2.0) return 1.0;
  return std::sqrt((blocks + 1.0) / (blocks - 1.0)) * (1.0 + 1.21 / (blocks - 1.0));
}

}  // namespace

Bootstrap block_bootstrap(std::span<const BlockSums> blocks, std::size_t draws, std::uint64_t seed) {
  if (blocks.empty()) return {};
  const Eigen::Index size = blocks.front().gradient.size();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
  for (const BlockSums& block : blocks) {
    information += block.information;
    gradient += block.gradient;
  }
  const Eigen::MatrixXd directions = known_directions(information);
  // Where a bound holds the estimate its gradient is not zero: no reason for all draws to lean there.
  const Eigen::VectorXd lean = directions.transpose() * gradient;
  std::vector<BlockSums> known;
  known.reserve(blocks.size());
  for (const BlockSums& block : blocks) {
    const Eigen::MatrixXd part = directions.transpose() * block.information * directions;
    known.push_back({part, directions.transpose() * block.gradient - part * lean});
  }

  std::mt19937_64 random(seed);
  const double few_blocks = small_sample_factor(static_cast<double>(blocks.size()));
  Bootstrap result;
  result.white_deviations = directions.rowwise().norm();
  result.deviations.resize(size, static_cast<Eigen::Index>(draws));
  for (Eigen::Index draw = 0; draw < result.deviations.cols(); ++draw) {
    BlockSums sum{Eigen::MatrixXd::Zero(directions.cols(), directions.cols()),
                  Eigen::VectorXd::Zero(directions.cols())};
    for (const BlockSums& block : known) {
      const double weight = random_weight(random);
      sum.information += weight * block.information;
      sum.gradient += weight * block.gradient;
    }
    result.deviations.col(draw) = -few_blocks * directions * solve_symmetric(sum.information, sum.gradient);
  }
  return result;
}

}  // namespace wheelwright::gap
