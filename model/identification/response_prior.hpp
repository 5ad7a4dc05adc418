// Regularised estimate of the wheels' impulse responses with a prior whose size is found by marginal
// likelihood.
#pragma once

#include <array>

#include <Eigen/Core>

namespace wheelwright {

// A least-squares problem for one wheel, reduced to its triangle: z = R h + e, plus `residual_square_sum`
// that no h explains, from `rows` equations. Columns alternate between the wheel's own and the other wheel's
// command.
struct ResponseProblem {
  Eigen::MatrixXd r;
  Eigen::VectorXd z;
  double residual_square_sum = 0.0;
  Eigen::Index rows = 0;
  double min_noise_variance = 0.0;  // what the encoder's ticks make certain, however well the rows fit
  Eigen::Index own_column = 0;  // 0 where the even columns are the wheel's own command, 1 where the odd are
};

// What is believed of impulse responses before any data: h_i of a channel has covariance
// size * decay^max(i,j), own and cross channel each with a size of their own, independent of each other.
struct ResponsePrior {
  double own_size = 1.0;     // (m/s per m/s)^2
  double cross_size = 1e-3;  // the same
  double decay = 0.8;        // per period
};

struct ResponseEstimate {
  Eigen::VectorXd response;     // posterior mean of h
  Eigen::MatrixXd covariance;   // posterior covariance of h
  double noise_variance = 0.0;  // of one whitened equation
};

// Sizes and decay are those of both wheels, since a robot's wheels are made alike, and maximise the marginal
// likelihood of both.
ResponsePrior most_likely_prior(const std::array<ResponseProblem, 2>& wheels);

ResponseEstimate estimate_response(const ResponseProblem& problem, const ResponsePrior& prior);

}  // namespace wheelwright
