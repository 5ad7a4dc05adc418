#include "model/identification/fir_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "model/identification/fit_checks.hpp"
#include "model/identification/least_squares_accumulator.hpp"
#include "model/identification/response_prior.hpp"
#include "model/identification/travel_equations.hpp"
#include "model/log/near_periods.hpp"

namespace wheelwright {
namespace {

struct Factored {
  LeastSquaresAccumulator::Factor factor;
  RelativeTravelNoise noise;
  double log_variance_sum = 0.0;
};

Factored factor_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                          const RelativeTravelNoise& noise) {
  LeastSquaresAccumulator accumulator(static_cast<Eigen::Index>(2 * taps), 2);
  const double log_variance_sum =
      whitened_travel_equations(logs, period_s, taps, noise,
                                [&](const Eigen::RowVectorXd& regressors, const Eigen::RowVector2d& targets) {
                                  accumulator.add_row(regressors, targets);
                                });
  return {accumulator.factor(), noise, log_variance_sum};
}

double negative_log_likelihood(const Factored& candidate) {
  const auto rows = static_cast<double>(candidate.factor.rows);
  double value = candidate.log_variance_sum;  // half of it for each of the two wheels
  for (const double square_sum : candidate.factor.residual_square_sum) {
    value += 0.5 * rows * std::log(std::max(square_sum / rows, 1e-30));
  }
  return value;
}

RelativeTravelNoise most_likely_noise(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                      double tick_m) {
  return most_likely_travel_noise(tick_m, period_s, [&](const RelativeTravelNoise& candidate) {
    return negative_log_likelihood(factor_equations(logs, period_s, taps, candidate));
  });
}

// The problem of one wheel with only the first `taps` taps: the leading block of the triangle; what the rest
// of the triangle explained goes back into the residual.
ResponseProblem problem_of(const LeastSquaresAccumulator::Factor& factor, Eigen::Index wheel,
                           std::size_t taps, double metres_per_tick) {
  const auto columns = static_cast<Eigen::Index>(2 * taps);
  ResponseProblem problem;
  problem.r = factor.r.topLeftCorner(columns, columns);
  problem.z = factor.z.col(wheel).head(columns);
  problem.residual_square_sum =
      factor.residual_square_sum[wheel] + factor.z.col(wheel).tail(factor.z.rows() - columns).squaredNorm();
  problem.rows = factor.rows;
  problem.min_noise_variance = metres_per_tick * metres_per_tick / 12.0;  // of rounding to whole ticks
  problem.own_column = wheel;
  return problem;
}

struct BothEstimates {
  ResponsePrior prior;
  ResponseEstimate left;
  ResponseEstimate right;
};

BothEstimates estimate_both(const LeastSquaresAccumulator::Factor& factor, std::size_t taps,
                            double metres_per_tick) {
  const std::array wheels{problem_of(factor, 0, taps, metres_per_tick),
                          problem_of(factor, 1, taps, metres_per_tick)};
  const ResponsePrior prior = most_likely_prior(wheels);
  return {prior, estimate_response(wheels[0], prior), estimate_response(wheels[1], prior)};
}

// The shortest length after which no tail is left that is both above its own uncertainty and above a
// thousandth of the whole response.
std::size_t length_worth_keeping(const ResponseEstimate& estimate) {
  const Eigen::Index columns = estimate.response.size();
  const double whole = estimate.response.cwiseAbs().sum();
  for (Eigen::Index tap = columns / 2; tap > 1; --tap) {
    for (Eigen::Index channel = 0; channel < 2; ++channel) {
      Eigen::VectorXd tail = Eigen::VectorXd::Zero(columns);
      for (Eigen::Index c = 2 * (tap - 1) + channel; c < columns; c += 2) tail[c] = 1.0;
      const double sum = tail.dot(estimate.response);
      const double deviation = std::sqrt(std::max(0.0, tail.dot(estimate.covariance * tail)));
      if (std::abs(sum) > 3.0 * deviation && std::abs(sum) > 0.001 * whole)
        return static_cast<std::size_t>(tap);
    }
  }
  return 1;
}

// A tap shows only in the rows that come so long after the run's first command. Taps that hardly any row
// shows make the whole response uncertain, and then no tail of it stands out. The last tap has a third of the
// longest run.
std::size_t longest_shown(std::span<const DriveLog> logs, double period_s, std::size_t longest) {
  double duration_s = 0.0;
  for (const DriveLog& log : logs) {
    duration_s = std::max(duration_s, log.samples.back().t_s - log.samples.front().t_s);
  }
  const auto shown = static_cast<std::size_t>(std::max(1.0, 2.0 / 3.0 * duration_s / period_s));
  return std::min(longest, shown);
}

WheelResponse to_response(const Eigen::VectorXd& columns) {
  WheelResponse response;
  for (Eigen::Index i = 0; i < columns.size(); i += 2) {
    response.from_left.push_back(columns[i]);
    response.from_right.push_back(columns[i + 1]);
  }
  return response;
}

WheelFit describe(const ResponseEstimate& estimate, const RelativeTravelNoise& noise, double period_s) {
  const Eigen::Index columns = estimate.response.size();
  WheelFit fit;
  const auto channel = [&](Eigen::Index first, double& gain, double& standard_error) {
    Eigen::VectorXd pick = Eigen::VectorXd::Zero(columns);
    for (Eigen::Index c = first; c < columns; c += 2) pick[c] = 1.0;
    gain = pick.dot(estimate.response);
    standard_error = std::sqrt(std::max(0.0, pick.dot(estimate.covariance * pick)));
  };
  channel(0, fit.gain.from_left, fit.gain_standard_error.from_left);
  channel(1, fit.gain.from_right, fit.gain_standard_error.from_right);
  fit.position_noise_m = std::sqrt(estimate.noise_variance);
  fit.drift_m_per_sqrt_s = std::sqrt(estimate.noise_variance * noise.drift_ratio / period_s);
  return fit;
}

struct Search {
  std::span<const DriveLog> logs;
  double period_s;
  double tick_m;
  RelativeTravelNoise noise;
};

struct Found {
  Factored factored;
  std::size_t length;
  bool cut;
};

Found search_to(const Search& search, std::size_t bound) {
  Factored factored = factor_equations(search.logs, search.period_s, bound, search.noise);
  const auto whole = estimate_both(factored.factor, bound, search.tick_m);
  const std::size_t length = std::max(length_worth_keeping(whole.left), length_worth_keeping(whole.right));
  return {std::move(factored), length, 10 * length > 9 * bound};
}

bool enough_rows(const Factored& factored, std::size_t taps) {
  return factored.factor.rows >= static_cast<Eigen::Index>(4 * taps);
}

// A bound that the response fills is doubled as long as the rows are enough for it.
Found search_beyond(const Search& search, Found found, std::size_t bound, std::size_t longest) {
  while (found.cut && bound < longest) {
    bound = std::min(2 * bound, longest);
    Found next = search_to(search, bound);
    if (!enough_rows(next.factored, bound)) break;
    found = std::move(next);
  }
  return found;
}

}  // namespace

tl::expected<FirFit, Refusal> fit_fir(std::span<const DriveLog> logs, const FirFitOptions& options) {
  if (auto refusal = find_unfit_log(logs)) return tl::unexpected(*refusal);
  const double period_s = options.period_s.value_or(shortest_period_s(logs));
  const std::size_t longest = longest_shown(logs, period_s, options.longest);
  const std::size_t bound = options.length.value_or(std::min(longest, options.first_bound));

  const double tick_m = 0.5 * (logs.front().metres_per_tick->left + logs.front().metres_per_tick->right);
  const RelativeTravelNoise noise =
      most_likely_noise(logs, period_s, std::min<std::size_t>(bound, 20), tick_m);
  const Search search{logs, period_s, tick_m, noise};
  Found found = search_to(search, bound);
  if (!enough_rows(found.factored, bound)) {
    const std::size_t needed = 4 * options.length.value_or(options.first_bound);
    return tl::unexpected(Refusal{"only " + std::to_string(found.factored.factor.rows) +
                                  " usable samples, but " + std::to_string(needed) +
                                  " are needed; record a longer run"});
  }
  if (!options.length) found = search_beyond(search, std::move(found), bound, longest);

  const std::size_t length = options.length.value_or(found.length);
  const LeastSquaresAccumulator::Factor& factor = found.factored.factor;
  const auto estimates = estimate_both(factor, length, tick_m);
  FirFit fit;
  fit.model = {ModelType::fir, period_s, logs.front().wheel_base_m, to_response(estimates.left.response),
               to_response(estimates.right.response)};
  fit.left = describe(estimates.left, noise, period_s);
  fit.right = describe(estimates.right, noise, period_s);
  fit.prior = estimates.prior;
  fit.rows = static_cast<std::size_t>(factor.rows);
  fit.cut = found.cut && !options.length;
  return fit;
}

}  // namespace wheelwright
