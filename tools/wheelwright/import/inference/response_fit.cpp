#include "tools/wheelwright/import/inference/response_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright::import {
namespace {

constexpr Eigen::Index lags = 30;  // rows of the past
constexpr std::size_t min_fitted_rows = 20;
constexpr std::size_t max_rows = 20'000;  // enough to decide, and quick

// Mean and standard deviation of the values that are finite.
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread_of(const std::vector<double>& values) {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    count += 1.0;
    sum += value;
    squares += value * value;
  }
  if (!(count > 0.0)) return {};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

}  // namespace

ResponseFit fit_response(const ResponseRows& rows, Baseline baseline) {
  const bool has_constant = baseline == Baseline::any;
  // About their mean, the commands are independent of the constant, which is made as large as they are.
  const Spread spread = has_constant ? spread_of(rows.command) : Spread{};
  const Eigen::Index size = has_constant ? lags + 1 : lags;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  double sum = 0.0;
  double squares = 0.0;
  std::size_t count = 0;
  std::size_t begin = 0;
  Eigen::VectorXd regressors = Eigen::VectorXd::Constant(size, spread.deviation);
  for (const std::size_t end : rows.run_ends) {
    for (std::size_t i = begin + lags; i < end && count < max_rows; ++i) {
      for (Eigen::Index lag = 0; lag < lags; ++lag)
        regressors[lag] = rows.command[i - static_cast<std::size_t>(lag)] - spread.mean;
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
  const Eigen::VectorXd response = solve_symmetric(damped, right);
  const double rest = squares - 2.0 * response.dot(right) + response.dot(full * response);
  fit.gain = response.head(lags).sum();
  if (has_constant) fit.at_zero = response[lags] * spread.deviation - fit.gain * spread.mean;
  fit.explained = std::clamp(1.0 - rest / variance, 0.0, 1.0);
  // Rounding leaves a rest that no model can explain: it bounds the evidence.
  fit.nats = -0.5 * n * std::log(std::max(1.0 - fit.explained, 1e-6));
  return fit;
}

}  // namespace wheelwright::import
