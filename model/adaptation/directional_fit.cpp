#include "model/adaptation/directional_fit.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace wheelwright {

DirectionalFit::DirectionalFit(const Vector& prior, double prior_standard_deviation, double memory_rows)
    : lambda_(std::exp(-1.0 / memory_rows)),
      weights_(prior),
      information_(Eigen::Matrix3d::Identity() / (prior_standard_deviation * prior_standard_deviation)) {}

void DirectionalFit::take(const Vector& regressors, double target) {
  if (regressors.squaredNorm() < 1.0) return;
  const Vector seen = information_ * regressors;
  information_ -= (1.0 - lambda_) / regressors.dot(seen) * seen * seen.transpose();
  information_ += regressors * regressors.transpose();
  weights_ += information_.ldlt().solve(regressors) * (target - regressors.dot(weights_));
}

Eigen::Matrix3d DirectionalFit::covariance() const {
  return information_.ldlt().solve(Eigen::Matrix3d::Identity());
}

}  // namespace wheelwright
