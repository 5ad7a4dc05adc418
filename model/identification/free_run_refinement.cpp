#include "model/identification/free_run_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/identification/filtered_run.hpp"
#include "model/identification/free_run_prior.hpp"
#include "model/statistics/levenberg_marquardt.hpp"

namespace wheelwright {
namespace {

using Factor = LeastSquaresAccumulator::Factor;

// Dampings are relative to the largest singular value: 1e4 and more moves nothing.
constexpr LevenbergMarquardtRule search_rule{.max_steps = 40, .max_attempts = 10, .first_damping = 1e-6};

// The steps of the whitening filter for one noise, reading by reading through all runs.
struct Whitening {
  std::vector<WhiteningStep> steps;
  double log_variance_sum = 0.0;
};

Whitening whitening_of(const FreeRunProblem& problem, const RelativeTravelNoise& noise) {
  Whitening result;
  WhiteningGains gains(noise);
  for (const auto& run : problem.runs) {
    for (const auto& reading : run.readings) {
      if (reading.restart) gains.restart();
      result.steps.push_back(gains.next(reading.periods_since, noise.reading_variance(reading.fastest_m_s)));
      result.log_variance_sum += result.steps.back().log_variance;
    }
  }
  return result;
}

double travel_m(const FreeRunProblem& problem, const TravelReading& reading) {
  return problem.side == WheelSide::left ? reading.travel_m.left : reading.travel_m.right;
}

// Measured travel minus that of the free run, reading by reading through all runs.
std::vector<double> residuals_m(const FreeRunProblem& problem, const WheelResponse& response) {
  std::vector<double> residuals;
  for (const auto& run : problem.runs) {
    const FilteredRun free(run, response, problem.layout, problem.period_s, false);
    for (const auto& reading : run.readings) {
      residuals.push_back(travel_m(problem, reading) - free.travel_m(reading));
    }
  }
  return residuals;
}

// What is left of residuals after whitening.
struct Misfit {
  double square_sum = 0.0;  // m^2
  double log_variance_sum = 0.0;
  double rows = 0.0;
};

// TravelWhitener on one column, which is all that most steps of a search need.
Misfit misfit(const std::vector<double>& residuals, const Whitening& whitening) {
  Misfit result;
  result.log_variance_sum = whitening.log_variance_sum;
  double level = 0.0;
  double drift = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const WhiteningStep& step = whitening.steps[i];
    if (step.starts) {
      level = residuals[i];
      drift = 0.0;
      continue;
    }
    drift *= step.kept;
    const double innovation = residuals[i] - level - drift;
    level += step.level_gain * innovation;
    drift += step.drift_gain * innovation;
    result.square_sum += step.scale * innovation * step.scale * innovation;
    result.rows += 1.0;
  }
  return result;
}

// Whitened rows of the linearised problem: sensitivities, then the residual.
template <typename Sink>
void sensitivity_rows(const FreeRunProblem& problem, const WheelResponse& response,
                      const Whitening& whitening, Sink sink) {
  const Eigen::Index columns = problem.layout.columns();
  TravelWhitener whitener(columns + 1);
  Eigen::RowVectorXd row(columns + 1);
  Eigen::RowVectorXd whitened(columns + 1);
  auto step = whitening.steps.begin();
  for (const auto& run : problem.runs) {
    const FilteredRun free(run, response, problem.layout, problem.period_s, true);
    for (const auto& reading : run.readings) {
      free.travel_sensitivities(reading, row);
      row[columns] = travel_m(problem, reading) - free.travel_m(reading);
      if (whitener.filter(row, *step++, whitened)) sink(whitened);
    }
  }
}

double prior_square_sum(const FreeRunProblem& problem, const WheelResponse& response) {
  double sum = 0.0;
  for_each_prior_row(problem, response, false,
                     [&](const Eigen::RowVectorXd& row) { sum += row[0] * row[0]; });
  return sum;
}

// Variance of the white noise that is left, and no less than rounding to whole ticks makes certain.
double noise_variance(const FreeRunProblem& problem, const Misfit& left) {
  return std::max(left.square_sum / std::max(1.0, left.rows), problem.tick_m * problem.tick_m / 12.0);
}

double negative_log_likelihood(const FreeRunProblem& problem, const Misfit& left) {
  return 0.5 * left.rows * std::log(noise_variance(problem, left)) + 0.5 * left.log_variance_sum;
}

// A response, judged under noise that is held fixed.
class FreeRunFit {
 public:
  struct Point {
    WheelResponse response;
    double cost = 0.0;
  };

  FreeRunFit(const FreeRunProblem& problem, const Whitening& whitening, double noise_variance)
      : problem_(problem), whitening_(whitening), noise_variance_(noise_variance) {}

  Point at(const WheelResponse& response) const {
    return {response, misfit(residuals_m(problem_, response), whitening_).square_sum +
                          noise_variance_ * prior_square_sum(problem_, response)};
  }
  static double objective(const Point& point) { return point.cost; }
  DampedSteps linearise(const Point& point) const { return DampedSteps(factor(point.response)); }
  std::optional<Point> moved(const Point& point, const Eigen::VectorXd& step) const {
    const WheelResponse response =
        problem_.layout.to_response(problem_.layout.to_unknowns(point.response) + step);
    if (!(largest_pole(response) < largest_allowed_pole)) return std::nullopt;
    return at(response);
  }

  // The linearised problem around a response.
  Factor factor(const WheelResponse& response) const {
    const Eigen::Index columns = problem_.layout.columns();
    LeastSquaresAccumulator accumulator(columns, 1);
    const auto add = [&](const Eigen::RowVectorXd& row) {
      accumulator.add_row(row.head(columns), row.tail(1));
    };
    sensitivity_rows(problem_, response, whitening_, add);
    const double weight = std::sqrt(noise_variance_);
    for_each_prior_row(problem_, response, true, [&](const Eigen::RowVectorXd& row) { add(weight * row); });
    return accumulator.factor();
  }

 private:
  const FreeRunProblem& problem_;
  const Whitening& whitening_;
  double noise_variance_;
};

}  // namespace

RefinedResponse refine_free_run(const FreeRunProblem& problem, const WheelResponse& start) {
  RefinedResponse result;
  result.response = start;
  Factor factor;
  Whitening whitening;
  // The noise can be told from the misfit only where the model is nearly right, so twice.
  for (int round = 0; round < 2; ++round) {
    const auto residuals = residuals_m(problem, result.response);
    result.noise =
        most_likely_travel_noise(problem.tick_m, problem.period_s, [&](const RelativeTravelNoise& candidate) {
          return negative_log_likelihood(problem, misfit(residuals, whitening_of(problem, candidate)));
        });
    whitening = whitening_of(problem, result.noise);
    result.noise_variance = noise_variance(problem, misfit(residuals, whitening));
    const FreeRunFit fit(problem, whitening, result.noise_variance);
    result.response = levenberg_marquardt(fit, fit.at(result.response), search_rule).response;
    factor = fit.factor(result.response);
  }
  const Misfit left = misfit(residuals_m(problem, result.response), whitening);
  result.last_step = solve_small(factor);
  result.noise_variance = noise_variance(problem, left);
  result.objective =
      negative_log_likelihood(problem, left) + 0.5 * prior_square_sum(problem, result.response);
  return result;
}

}  // namespace wheelwright
