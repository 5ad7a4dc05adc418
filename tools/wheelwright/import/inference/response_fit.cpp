#include "tools/wheelwright/import/inference/response_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace wheelwright::import {
namespace {

constexpr Eigen::Index lags = 30;  // rows of the past
constexpr std::size_t min_fitted_rows = 20;
constexpr std::size_t max_rows = 20'000;  // enough to decide, and quick

}  // namespace

ResponseFit fit_response(const ResponseRows& rows) {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(lags, lags);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(lags);
  double sum = 0.0;
  double squares = 0.0;
  std::size_t count = 0;
  std::size_t begin = 0;
  Eigen::VectorXd regressors(lags);
  for (const std::size_t end : rows.run_ends) {
    for (std::size_t i = begin + lags; i < end && count < max_rows; ++i) {
      for (Eigen::Index lag = 0; lag < lags; ++lag)
        regressors[lag] = rows.command[i - static_cast<std::size_t>(lag)];
      const double speed = rows.speed[i];
      if (!std::isfinite(speed) || !regressors.allFinite()) continue;
      normal.selfadjointView<Eigen::Lower>().rankUpdate(regressors);
      right += speed * regressors;
      sum += speed;
      squares += speed * speed;
      ++count;
    }
    begin = end;
  }
  ResponseFit fit;
  const auto n = static_cast<double>(count);
  const double variance = squares - sum * sum / n;
  if (count < min_fitted_rows || !(variance > 0.0)) return fit;
  const Eigen::MatrixXd full = normal.selfadjointView<Eigen::Lower>();
  // A command that is held makes its lags alike: a small ridge keeps their sum, which is the gain.
  const double ridge = 1e-6 * full.diagonal().mean();
  if (!(ridge > 0.0)) return fit;
  Eigen::MatrixXd damped = full;
  damped.diagonal().array() += ridge;
  const Eigen::VectorXd response = damped.ldlt().solve(right);
  const double rest = squares - 2.0 * response.dot(right) + response.dot(full * response);
  fit.gain = response.sum();
  fit.explained = std::clamp(1.0 - rest / variance, 0.0, 1.0);
  // Rounding leaves a rest that no model can explain: it bounds the evidence.
  fit.nats = -0.5 * n * std::log(std::max(1.0 - fit.explained, 1e-6));
  return fit;
}

}  // namespace wheelwright::import
