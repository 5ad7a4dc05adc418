#include "model/identification/response_prior.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelwright {
namespace {

// The sizes range over many decades.
struct SearchedPrior {
  double log10_own = 0.0;
  double log10_cross = -3.0;
  double decay = 0.8;

  ResponsePrior prior() const { return {std::pow(10.0, log10_own), std::pow(10.0, log10_cross), decay}; }
};

Eigen::MatrixXd prior_covariance(const ResponsePrior& prior, Eigen::Index columns, Eigen::Index own_column) {
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(columns, columns);
  for (Eigen::Index a = 0; a < columns; ++a) {
    for (Eigen::Index b = a % 2; b < columns; b += 2) {
      const double size = a % 2 == own_column ? prior.own_size : prior.cross_size;
      covariance(a, b) = size * std::pow(prior.decay, static_cast<double>(std::max(a / 2, b / 2)));
    }
  }
  return covariance;
}

// z is Gaussian with covariance R P R' + s I under the prior.
Eigen::LLT<Eigen::MatrixXd> evidence_factor(const ResponseProblem& problem, const Eigen::MatrixXd& prior,
                                            double noise_variance) {
  Eigen::MatrixXd covariance = problem.r * prior * problem.r.transpose();
  // Exact data would leave no noise at all and a covariance that is singular in rounding.
  const double floor = 1e-15 * covariance.diagonal().maxCoeff();
  covariance.diagonal().array() += std::max(noise_variance, floor);
  return Eigen::LLT<Eigen::MatrixXd>(covariance);
}

// Repetitions of one manoeuvre round their ticks alike, which a free enough response would fit as if it were
// motion: hence a floor.
double noise_variance_of(const ResponseProblem& problem) {
  const auto spare = std::max<Eigen::Index>(1, problem.rows - problem.r.cols());
  return std::max(problem.residual_square_sum / static_cast<double>(spare), problem.min_noise_variance);
}

double negative_log_evidence(const ResponseProblem& problem, const ResponsePrior& prior) {
  const auto factor = evidence_factor(problem, prior_covariance(prior, problem.r.cols(), problem.own_column),
                                      noise_variance_of(problem));
  if (factor.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd whitened = factor.matrixL().solve(problem.z);
  return 0.5 * whitened.squaredNorm() + factor.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

// One variable at a time with a shrinking step: the surface is smooth and has three dimensions.
ResponsePrior most_likely_prior(const std::array<ResponseProblem, 2>& wheels) {
  const auto evidence = [&](const SearchedPrior& candidate) {
    const ResponsePrior prior = candidate.prior();
    return negative_log_evidence(wheels[0], prior) + negative_log_evidence(wheels[1], prior);
  };
  SearchedPrior best;
  double best_value = evidence(best);
  const auto consider = [&](SearchedPrior candidate) {
    candidate.log10_own = std::clamp(candidate.log10_own, -8.0, 3.0);
    candidate.log10_cross = std::clamp(candidate.log10_cross, -12.0, 3.0);
    candidate.decay = std::clamp(candidate.decay, 0.4, 0.985);
    const double value = evidence(candidate);
    if (value >= best_value) return;
    best_value = value;
    best = candidate;
  };
  for (double step = 1.0; step > 0.1; step *= 0.6) {
    for (int round = 0; round < 2; ++round) {
      for (const double sign : {-1.0, 1.0}) {
        consider({best.log10_own + sign * step, best.log10_cross, best.decay});
        consider({best.log10_own, best.log10_cross + 2.0 * sign * step, best.decay});
        consider({best.log10_own, best.log10_cross, best.decay + 0.15 * sign * step});
      }
    }
  }
  return best.prior();
}

ResponseEstimate estimate_response(const ResponseProblem& problem, const ResponsePrior& prior) {
  ResponseEstimate estimate;
  estimate.noise_variance = noise_variance_of(problem);
  const Eigen::MatrixXd covariance = prior_covariance(prior, problem.r.cols(), problem.own_column);
  const auto factor = evidence_factor(problem, covariance, estimate.noise_variance);
  const Eigen::MatrixXd gain = factor.solve(problem.r * covariance).transpose();
  estimate.response = gain * problem.z;
  estimate.covariance = covariance - gain * problem.r * covariance;
  return estimate;
}

}  // namespace wheelwright
