#include "model/identification/free_run_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/identification/filtered_run.hpp"

namespace wheelwright {
namespace {

using Factor = LeastSquaresAccumulator::Factor;

constexpr std::size_t prior_periods = 60;      // in which a response is over
constexpr double past_weight_deviation = 0.3;  // of what is believed of a weight of a past speed
constexpr int most_steps = 40;
constexpr double least_progress = 1e-7;  // of the square sum, in one step
constexpr double first_damping = 1e-6;
constexpr double most_damping = 1e4;

// Hands the whitened rows of all runs to a sink: sensitivities (where wanted), then the residual.
template <typename Sink>
double whitened_rows(const FreeRunProblem& problem, const WheelResponse& response, const TravelNoise& noise,
                     bool with_sensitivities, Sink sink) {
  const Eigen::Index columns = with_sensitivities ? problem.layout.columns() : 0;
  TravelWhitener whitener(columns + 1, noise);
  Eigen::RowVectorXd row(columns + 1);
  Eigen::RowVectorXd whitened(columns + 1);
  for (const auto& run : problem.runs) {
    const FilteredRun filtered(run, response, problem.layout, problem.period_s, with_sensitivities);
    for (const auto& reading : run.readings) {
      if (reading.restart) whitener.restart();
      if (with_sensitivities) filtered.travel_sensitivities(reading, row);
      const double measured =
          problem.side == WheelSide::left ? reading.travel_m.left : reading.travel_m.right;
      row[columns] = measured - filtered.travel_m(reading);
      const double variance = noise.reading_variance(reading.fastest_m_s);
      if (whitener.filter(row, reading.periods_since, variance, whitened)) sink(whitened);
    }
  }
  return whitener.log_variance_sum();
}

// Many recursions have the same free run: a pole and a zero that cancel change nothing. Of those the one with
// small weights of the past is wanted, for a hybrid filter feeds measured speeds into them, with their noise.
template <typename Sink>
void recursion_rows(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                    Sink sink) {
  const Eigen::Index columns = with_sensitivities ? problem.layout.columns() : 0;
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(columns + 1);
  for (std::size_t i = 0; i < response.from_own_past.size(); ++i) {
    const Eigen::Index column = problem.layout.command_columns() + static_cast<Eigen::Index>(i);
    if (with_sensitivities) row[column] = 1.0 / past_weight_deviation;
    row[columns] = -response.from_own_past[i] / past_weight_deviation;
    sink(row);
    if (with_sensitivities) row[column] = 0.0;
  }
}

// What the prior has to say against an impulse response, as rows of unit variance. Under it h_i - h_(i+1) are
// independent with variance size * (decay^i - decay^(i+1)), and the last h is so with what is left.
template <typename Sink>
void impulse_rows(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                  Sink sink) {
  if (!problem.prior) return;
  const Eigen::Index columns = with_sensitivities ? problem.layout.columns() : 0;
  Eigen::RowVectorXd row(columns + 1);
  Eigen::RowVectorXd next(columns + 1);
  for (const WheelSide driven : {WheelSide::left, WheelSide::right}) {
    TravelRun impulse;
    impulse.commands_m_s.resize(prior_periods);
    (driven == WheelSide::left ? impulse.commands_m_s[0].left : impulse.commands_m_s[0].right) = 1.0;
    const FilteredRun filtered(impulse, response, problem.layout, problem.period_s, with_sensitivities);
    const double size = driven == problem.side ? problem.prior->own_size : problem.prior->cross_size;
    double variance = size;  // of h_i
    next.setZero();
    for (std::size_t i = 0; i < prior_periods; ++i) {
      const auto value_at = [&](std::size_t period, Eigen::RowVectorXd& into) {
        if (with_sensitivities) filtered.speed_sensitivities(period, into);
        into[columns] = -filtered.speed_m_s(period);
      };
      value_at(i, row);
      double step_variance = variance;
      if (i + 1 < prior_periods) {
        value_at(i + 1, next);
        row -= next;
        step_variance *= 1.0 - problem.prior->decay;
      }
      row /= std::sqrt(step_variance);
      sink(row);
      variance *= problem.prior->decay;
    }
  }
}

template <typename Sink>
void prior_rows(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                Sink sink) {
  recursion_rows(problem, response, with_sensitivities, sink);
  impulse_rows(problem, response, with_sensitivities, sink);
}

struct Misfit {
  double square_sum = 0.0;        // of whitened residuals, m^2
  double log_variance_sum = 0.0;  // of the whitening
  double rows = 0.0;
};

Misfit misfit(const FreeRunProblem& problem, const WheelResponse& response, const TravelNoise& noise) {
  Misfit result;
  result.log_variance_sum =
      whitened_rows(problem, response, noise, false, [&](const Eigen::RowVectorXd& whitened) {
        result.square_sum += whitened[0] * whitened[0];
        result.rows += 1.0;
      });
  return result;
}

double prior_square_sum(const FreeRunProblem& problem, const WheelResponse& response) {
  double sum = 0.0;
  prior_rows(problem, response, false, [&](const Eigen::RowVectorXd& row) { sum += row[0] * row[0]; });
  return sum;
}

// Variance of the white noise that is left, and no less than rounding to whole ticks makes certain.
double noise_variance(const FreeRunProblem& problem, const Misfit& left) {
  return std::max(left.square_sum / std::max(1.0, left.rows), problem.tick_m * problem.tick_m / 12.0);
}

double negative_log_likelihood(const FreeRunProblem& problem, const Misfit& left) {
  return 0.5 * left.rows * std::log(noise_variance(problem, left)) + 0.5 * left.log_variance_sum;
}

// One search with the noise held fixed.
class Search {
 public:
  Search(const FreeRunProblem& problem, const TravelNoise& noise, double noise_variance)
      : problem_(problem), noise_(noise), noise_variance_(noise_variance) {}

  // Improves `response` by Levenberg-Marquardt steps and returns the linearised problem around it.
  Factor run(WheelResponse& response) const {
    double best = cost(response);
    double damping = first_damping;
    Factor factor = linearise(response);
    DampedSteps steps(factor);
    for (int step = 0; step < most_steps && damping < most_damping; ++step) {
      const Eigen::VectorXd unknowns = problem_.layout.to_unknowns(response) + steps.step(damping);
      const WheelResponse candidate = problem_.layout.to_response(unknowns);
      const double reached = cost(candidate);
      if (!(reached < best)) {
        damping *= 10.0;
        continue;
      }
      const double progress = (best - reached) / best;
      best = reached;
      response = candidate;
      damping *= 0.1;
      factor = linearise(response);
      if (progress < least_progress) break;
      steps = DampedSteps(factor);
    }
    return factor;
  }

 private:
  double cost(const WheelResponse& response) const {
    if (!(largest_pole(response) < largest_allowed_pole)) return std::numeric_limits<double>::infinity();
    return misfit(problem_, response, noise_).square_sum +
           noise_variance_ * prior_square_sum(problem_, response);
  }

  Factor linearise(const WheelResponse& response) const {
    const Eigen::Index columns = problem_.layout.columns();
    LeastSquaresAccumulator accumulator(columns, 1);
    const auto add = [&](const Eigen::RowVectorXd& row) {
      accumulator.add_row(row.head(columns), row.tail(1));
    };
    whitened_rows(problem_, response, noise_, true, add);
    const double weight = std::sqrt(noise_variance_);
    prior_rows(problem_, response, true, [&](const Eigen::RowVectorXd& row) { add(weight * row); });
    return accumulator.factor();
  }

  const FreeRunProblem& problem_;
  const TravelNoise& noise_;
  double noise_variance_;
};

}  // namespace

RefinedResponse refine_free_run(const FreeRunProblem& problem, const WheelResponse& start) {
  RefinedResponse result;
  result.response = start;
  const auto left_over = [&](const TravelNoise& noise) { return misfit(problem, result.response, noise); };
  Factor factor;
  // The noise can be told from the misfit only where the model is nearly right, so twice.
  for (int round = 0; round < 2; ++round) {
    result.noise = most_likely_travel_noise(problem.tick_m, problem.period_s, [&](const TravelNoise& noise) {
      return negative_log_likelihood(problem, left_over(noise));
    });
    result.noise_variance = noise_variance(problem, left_over(result.noise));
    factor = Search(problem, result.noise, result.noise_variance).run(result.response);
  }
  const Misfit left = left_over(result.noise);
  result.last_step = solve_small(factor);
  result.noise_variance = noise_variance(problem, left);
  result.objective =
      negative_log_likelihood(problem, left) + 0.5 * prior_square_sum(problem, result.response);
  return result;
}

}  // namespace wheelwright
