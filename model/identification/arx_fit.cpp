#include "model/identification/arx_fit.hpp"

#include <cmath>
#include <string>

#include "model/free_run.hpp"
#include "model/identification/arx_accumulator.hpp"
#include "model/identification/fit_checks.hpp"
#include "model/identification/run_periods.hpp"
#include "model/identification/small_solve.hpp"
#include "model/score.hpp"

namespace wheelwright {
namespace {

using Factor = LeastSquaresAccumulator::Factor;

constexpr Eigen::Index rows_per_unknown = 4;
// Commands below this share of independence from each other show nothing but rounding.
constexpr double weakest_command_direction = 1e-6;

ArxAccumulator stack_equations(std::span<const DriveLog> logs, double period_s, const ArxLayout& layout) {
  ArxAccumulator accumulator(layout);
  for (const auto& log : logs) {
    accumulator.start_from_rest();
    for_each_period(log, period_s, [&](const RunPeriod& period) {
      if (period.in_hole) return accumulator.lose_past();
      accumulator.add(period.command_m_s, period.speed_m_s);
    });
  }
  return accumulator;
}

// The command columns come first, so the leading block of the triangle is their own.
std::optional<Refusal> find_missing_command_changes(const Factor& factor, const ArxLayout& layout) {
  Factor commands;
  commands.r = factor.r.topLeftCorner(layout.command_columns(), layout.command_columns());
  commands.z = Eigen::MatrixXd::Zero(layout.command_columns(), 1);
  commands.residual_square_sum = Eigen::VectorXd::Zero(1);
  commands.rows = factor.rows;
  if (solve_small(commands).condition < 1.0 / weakest_command_direction) return std::nullopt;
  return Refusal{"the commands change too rarely to tell the weights of order " +
                 std::to_string(layout.order) +
                 " apart; record a run whose commands change at random about every ten periods, or fit a "
                 "lower order"};
}

std::optional<Refusal> find_too_few_rows(Eigen::Index rows, const ArxLayout& layout) {
  const Eigen::Index needed = rows_per_unknown * layout.columns();
  if (rows >= needed) return std::nullopt;
  return Refusal{"only " + std::to_string(rows) + " usable rows, but order " + std::to_string(layout.order) +
                 " needs " + std::to_string(needed) + "; record a longer run, or fit a lower order"};
}

Refusal runs_away(double pole, std::size_t order) {
  return {"the fit of order " + std::to_string(order) + " runs away (largest pole " + std::to_string(pole) +
          ", must be below 1); record a longer run with more changes of command, or fit another order"};
}

// Standard errors of the gain by the derivative of B(1) / (1 - A(1)) after each weight.
void describe_gain(const WheelResponse& response, const Eigen::MatrixXd& covariance, const ArxLayout& layout,
                   WheelFit& quality) {
  quality.gain = dc_gain(response);
  double rest = 1.0;
  for (const double weight : response.from_own_past) rest -= weight;
  const auto error = [&](Eigen::Index first, double gain) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(layout.columns());
    for (Eigen::Index c = first; c < layout.command_columns(); c += 2) slope[c] = 1.0 / rest;
    slope.tail(static_cast<Eigen::Index>(layout.order)).setConstant(gain / rest);
    return std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
  };
  quality.gain_standard_error = {error(0, quality.gain.from_left), error(1, quality.gain.from_right)};
}

struct EstimatedWheel {
  WheelResponse response;
  ArxWheelFit fit;
};

EstimatedWheel estimate_from_equations(const Factor& factor, const ArxLayout& layout) {
  const SmallSolution solution = solve_small(factor);
  EstimatedWheel wheel;
  wheel.response = layout.to_response(solution.unknowns);
  wheel.fit.standard_errors = layout.to_response(solution.deviations);
  wheel.fit.condition = solution.condition;
  wheel.fit.rank = static_cast<std::size_t>(solution.rank);
  wheel.fit.unknowns = static_cast<std::size_t>(layout.columns());
  wheel.fit.largest_pole = largest_pole(wheel.response);
  wheel.fit.one_step_rms_m_s =
      std::sqrt(residual_square_sum(factor, solution.unknowns) / static_cast<double>(factor.rows));
  describe_gain(wheel.response, solution.covariance, layout, wheel.fit.quality);
  return wheel;
}

}  // namespace

tl::expected<ArxFit, Refusal> fit_arx(std::span<const DriveLog> logs, const ArxFitOptions& options) {
  if (auto refusal = find_unfit_log(logs)) return tl::unexpected(*refusal);
  const double period_s = options.period_s.value_or(logs.front().period_s);
  const ArxLayout layout{options.order, options.delay};
  ArxAccumulator equations = stack_equations(logs, period_s, layout);
  if (auto refusal = find_too_few_rows(equations.rows(), layout)) return tl::unexpected(*refusal);
  const Factor left_factor = equations.left_factor();
  const Factor right_factor = equations.right_factor();
  if (auto refusal = find_missing_command_changes(left_factor, layout)) return tl::unexpected(*refusal);

  const EstimatedWheel left = estimate_from_equations(left_factor, layout);
  const EstimatedWheel right = estimate_from_equations(right_factor, layout);
  const double pole = std::max(left.fit.largest_pole, right.fit.largest_pole);
  if (pole >= 1.0) return tl::unexpected(runs_away(pole, options.order));

  ArxFit fit;
  fit.model = {ModelType::arma, period_s, logs.front().wheel_base_m, left.response, right.response};
  fit.left = left.fit;
  fit.right = right.fit;
  fit.rows = static_cast<std::size_t>(equations.rows());
  ScoreSums sums;
  for (const auto& log : logs) sums.add(free_run(fit.model, log), log);
  fit.free_run_distance_rms_m = sums.score().distance_rms_m.value_or(0.0);
  return fit;
}

}  // namespace wheelwright
