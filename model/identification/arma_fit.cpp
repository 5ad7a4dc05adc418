#include "model/identification/arma_fit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "model/identification/arma_accumulator.hpp"
#include "model/identification/fit_checks.hpp"
#include "model/identification/free_run_refinement.hpp"
#include "model/identification/free_run_starts.hpp"
#include "model/identification/held_out_error.hpp"
#include "model/identification/least_squares_solution.hpp"
#include "model/log/near_periods.hpp"
#include "model/log/run_periods.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"
#include "model/prediction/segments.hpp"

namespace wheelwright {
namespace {

using Factor = LeastSquaresAccumulator::Factor;

constexpr Eigen::Index rows_per_unknown = 4;
// A wheel that remembers for more than 200 periods is a fit that ran into its limit, not a wheel.
constexpr double slowest_pole = 0.995;
// Commands below this share of independence from each other show nothing but rounding.
constexpr double weakest_command_direction = 1e-6;

ArmaAccumulator stack_equations(std::span<const DriveLog> logs, double period_s, const ArmaLayout& layout) {
  ArmaAccumulator accumulator(layout);
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
std::optional<Refusal> find_missing_command_changes(const Factor& factor, const ArmaLayout& layout) {
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

std::optional<Refusal> find_too_few_rows(Eigen::Index rows, const ArmaLayout& layout) {
  const Eigen::Index needed = rows_per_unknown * layout.columns();
  if (rows >= needed) return std::nullopt;
  return Refusal{"only " + std::to_string(rows) + " usable rows, but order " + std::to_string(layout.order) +
                 " needs " + std::to_string(needed) + "; record a longer run, or fit a lower order"};
}

Refusal runs_away(double pole, std::size_t order) {
  const std::string what = pole >= 1.0 ? "runs away" : "never comes to rest";
  return {"the fit of order " + std::to_string(order) + " " + what + " (largest pole " +
          std::to_string(pole) + ", must be below " + std::to_string(slowest_pole) +
          "); record a longer run with more changes of command, or fit another order"};
}

// A free run with this share of the travel wrong is hardly better than none, however its poles look.
constexpr double max_unexplained = 0.9;

std::optional<Refusal> find_unexplained_travel(std::span<const DriveLog> logs, const LinearModel& model) {
  LinearModel standing = model;
  standing.left = {{0.0}, {0.0}, {}};
  standing.right = standing.left;
  double wrong = 0.0;
  double travelled = 0.0;
  for (const auto& log : logs) {
    const double start_s = log.samples.front().t_s;
    for (const double square : block_distance_squares(model, log, start_s)) wrong += square;
    for (const double square : block_distance_squares(standing, log, start_s)) travelled += square;
  }
  if (wrong <= max_unexplained * max_unexplained * travelled) return std::nullopt;
  return Refusal{
      "the free run of the fit has more than half of the wheels' travel wrong: the wheels did not "
      "do what they were commanded; check that counts and commands belong together, and record a "
      "longer run on free floor"};
}

// Standard errors of the gain by the derivative of B(1) / (1 - A(1)) after each weight.
void describe_gain(const WheelResponse& response, const Eigen::MatrixXd& covariance, const ArmaLayout& layout,
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
  ArmaWheelFit fit;
};

EstimatedWheel estimate_from_equations(const Factor& factor, const ArmaLayout& layout) {
  const SmallSolution solution = solve_small(factor);
  EstimatedWheel wheel;
  wheel.response = layout.to_response(solution.unknowns);
  wheel.fit.standard_errors = layout.to_response(solution.deviations);
  wheel.fit.condition = solution.condition;
  wheel.fit.rank = static_cast<std::size_t>(solution.rank);
  wheel.fit.unknowns = static_cast<std::size_t>(layout.columns());
  describe_gain(wheel.response, solution.covariance, layout, wheel.fit.quality);
  return wheel;
}

// Refines from the plain fit and from the reduced moving average, and keeps the likelier result: each is the
// better start on some logs.
void refine(const FreeRunProblem& problem, const WheelResponse* reduced, EstimatedWheel& wheel) {
  RefinedResponse best = refine_free_run(problem, drawn_to_stability(wheel.response));
  if (reduced != nullptr) {
    RefinedResponse other = refine_free_run(problem, drawn_to_stability(*reduced));
    if (other.objective < best.objective) best = std::move(other);
  }
  const SmallSolution& step = best.last_step;
  wheel.response = best.response;
  wheel.fit.standard_errors = problem.layout.to_response(step.deviations);
  describe_gain(wheel.response, step.covariance, problem.layout, wheel.fit.quality);
  const double variance = best.noise_variance;
  wheel.fit.quality.position_noise_m = std::sqrt(variance);
  wheel.fit.quality.drift_m_per_sqrt_s = std::sqrt(variance * best.noise.drift_ratio / problem.period_s);
}

// Runs of one robot, checked, with what fits of all orders share.
class ArmaData {
 public:
  ArmaData(std::span<const DriveLog> logs, double period_s) : logs_(logs), period_s_(period_s) {}

  tl::expected<ArmaFit, Refusal> fit(const ArmaLayout& layout, ArmaMethod method) {
    ArmaAccumulator equations = stack_equations(logs_, period_s_, layout);
    if (auto refusal = find_too_few_rows(equations.rows(), layout)) return tl::unexpected(*refusal);
    const Factor left_factor = equations.left_factor();
    const Factor right_factor = equations.right_factor();
    if (auto refusal = find_missing_command_changes(left_factor, layout)) return tl::unexpected(*refusal);

    EstimatedWheel left = estimate_from_equations(left_factor, layout);
    EstimatedWheel right = estimate_from_equations(right_factor, layout);
    if (method == ArmaMethod::free_run) refine_both(layout, left, right);
    finish(left_factor, layout, left);
    finish(right_factor, layout, right);
    const double pole = std::max(left.fit.largest_pole, right.fit.largest_pole);
    if (pole >= slowest_pole) return tl::unexpected(runs_away(pole, layout.order));
    ArmaFit result = summary(left, right, equations.rows());
    if (auto refusal = find_unexplained_travel(logs_, result.model)) return tl::unexpected(*refusal);
    return result;
  }

 private:
  void refine_both(const ArmaLayout& layout, EstimatedWheel& left, EstimatedWheel& right) {
    prepare_refinement();
    std::optional<LinearModel> reduced;
    std::optional<ResponsePrior> prior;
    if (moving_average_) {
      reduced = reduce_to_arma(moving_average_->model, logs_, layout);
      prior = moving_average_->prior;
    }
    const WheelPair& tick_m = *logs_.front().metres_per_tick;
    refine({runs_, period_s_, tick_m.left, WheelSide::left, layout, prior},
           reduced ? &reduced->left : nullptr, left);
    refine({runs_, period_s_, tick_m.right, WheelSide::right, layout, prior},
           reduced ? &reduced->right : nullptr, right);
  }

  void prepare_refinement() {
    if (!runs_.empty()) return;
    runs_ = travel_runs(logs_, period_s_);
    FirFitOptions options;
    options.period_s = period_s_;
    if (auto fit = fit_fir(logs_, options)) moving_average_ = std::move(*fit);
  }

  static void finish(const Factor& factor, const ArmaLayout& layout, EstimatedWheel& wheel) {
    wheel.fit.largest_pole = largest_pole(wheel.response);
    const double square_sum = residual_square_sum(factor, layout.to_unknowns(wheel.response));
    wheel.fit.one_step_rms_m_s = std::sqrt(square_sum / static_cast<double>(factor.rows));
  }

  ArmaFit summary(const EstimatedWheel& left, const EstimatedWheel& right, Eigen::Index rows) const {
    ArmaFit fit;
    fit.model = {ModelType::arma, period_s_, logs_.front().wheel_base_m, left.response, right.response};
    fit.left = left.fit;
    fit.right = right.fit;
    fit.rows = static_cast<std::size_t>(rows);
    ScoreSums sums;
    for (const auto& log : logs_) add_segments(free_run(fit.model, log), log, period_s_, sums);
    fit.free_run_distance_rms_m = sums.score().distance_rms_m.value_or(0.0);
    return fit;
  }

  std::span<const DriveLog> logs_;
  double period_s_;
  std::vector<TravelRun> runs_;
  std::optional<FirFit> moving_average_;
};

OrderTrial to_trial(const ArmaFit& fit) {
  return {fit.model, std::max(fit.left.one_step_rms_m_s, fit.right.one_step_rms_m_s),
          std::max(fit.left.largest_pole, fit.right.largest_pole),
          std::max(fit.left.condition, fit.right.condition)};
}

}  // namespace

tl::expected<ArmaFit, Refusal> fit_arma(std::span<const DriveLog> logs, const ArmaFitOptions& options) {
  if (auto refusal = find_unfit_log(logs)) return tl::unexpected(*refusal);
  const double period_s = options.period_s.value_or(shortest_period_s(logs));
  const auto fit_of = [&](ArmaData& data, std::size_t order) {
    return data.fit({order, std::min(options.delay, order)}, options.method);
  };
  std::optional<OrderSweep> sweep;
  if (!options.order) {
    auto swept =
        sweep_orders(logs, options.largest_order, options.on_order, [&](std::span<const DriveLog> training) {
          return [&fit_of, data = ArmaData(training, period_s)](std::size_t order) mutable {
            return fit_of(data, order).map(to_trial);
          };
        });
    if (!swept) return tl::unexpected(swept.error());
    sweep = std::move(*swept);
  }
  ArmaData data(logs, period_s);
  auto fit = fit_of(data, sweep ? sweep->chosen : *options.order);
  if (fit) fit->sweep = std::move(sweep);
  return fit;
}

}  // namespace wheelwright
