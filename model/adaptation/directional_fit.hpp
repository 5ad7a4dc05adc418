// Recursive least squares that forgets only where something new is learnt.
//
// Plain exponential forgetting loses what is not being refreshed: on a robot that stands, or drives straight
// for long, the information on everything else decays and the covariance grows without bound ("windup"),
// until one noisy reading throws the estimate far off. Directional forgetting takes from the information
// matrix R only along the regressors x that came in (Cao & Schwartz, Automatica 36 (2000) 1725-1731):
//
//   R <- R - (1 - lambda) R x x' R / (x' R x) + x x'
//
// so that directions which are not excited keep what was known of them, while those that are track a change.
// It is chosen over a threshold on information since it needs no judgement of what is enough; rows that are
// smaller than one standard deviation of a reading are left out, since they would forget more than they tell.
#pragma once

#include <Eigen/Core>

namespace wheelwright {

class DirectionalFit {
 public:
  using Vector = Eigen::Vector3d;

  // `memory_rows`: after so many rows along a direction what was before has faded to 1/e.
  DirectionalFit(const Vector& prior, double prior_standard_deviation, double memory_rows);

  // One equation, regressors . weights = target, both sides in standard deviations of the target.
  void take(const Vector& regressors, double target);

  const Vector& weights() const { return weights_; }
  Eigen::Matrix3d covariance() const;

 private:
  double lambda_;
  Vector weights_;
  Eigen::Matrix3d information_;
};

}  // namespace wheelwright
