#include "model/gap/pose_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/data_checks/gate_state.hpp"
#include "model/gap/fit/parameter_intervals.hpp"
#include "model/gap/selection/search_start.hpp"
#include "model/identification/excitation.hpp"
#include "model/log/near_periods.hpp"
#include "model/statistics/confidence.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double max_unsure = 0.5;  // half of an interval, relative to the value
constexpr int steps_of_a_fit = 60;

// Of the whole response, with the gain that both wheels share.
double gain_of(const TrialModel& model) {
  double own_past = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < model.shape.poles; ++i) own_past += model.linear_part[i];
  for (std::size_t i = 0; i < model.shape.weights; ++i) weights += model.linear_part[model.shape.poles + i];
  return weights / (1.0 - own_past);
}

// By which travel is behind a command that rises evenly, once the start is forgotten.
double lag_s_of(const TrialModel& model) {
  double own_past = 0.0, own_moment = 0.0, weights = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < model.shape.poles; ++i) {
    own_past += model.linear_part[i];
    own_moment += static_cast<double>(i + 1) * model.linear_part[i];
  }
  for (std::size_t i = 0; i < model.shape.weights; ++i) {
    const double weight = model.linear_part[model.shape.poles + i];
    weights += weight;
    moment += static_cast<double>(i) * weight;
  }
  return model.period_s * (moment / weights + own_moment / (1.0 - own_past));
}

double left_gain_of(const TrialModel& model) {
  return gain_of(model) * (1.0 - 0.5 * model.excess_of_right());
}

double right_gain_of(const TrialModel& model) {
  return gain_of(model) * (1.0 + 0.5 * model.excess_of_right());
}

double wheel_base_m_of(const TrialModel& model) {
  return model.wheel_base_m + model.effects.front().parameters.front();
}

struct Figure {
  const char* what;
  double (*of)(const TrialModel&);
  const char* missing;  // what would show it
};
constexpr std::array figures{Figure{"the gain of the left wheel", left_gain_of, "drives"},
                             Figure{"the gain of the right wheel", right_gain_of, "drives"},
                             Figure{"the lag", lag_s_of, "starts and stops"},
                             Figure{"the wheel base", wheel_base_m_of, "turns"}};

Eigen::RowVectorXd slope_of(const Figure& figure, const TrialModel& model) {
  constexpr double step = 1e-6;
  Eigen::RowVectorXd slope(static_cast<Eigen::Index>(model.parameter_count()));
  for (std::size_t i = 0; i < model.parameter_count(); ++i) {
    TrialModel more = model;
    TrialModel less = model;
    more.set_parameter(i, model.parameter(i) + step);
    less.set_parameter(i, model.parameter(i) - step);
    slope(static_cast<Eigen::Index>(i)) = (figure.of(more) - figure.of(less)) / (2.0 * step);
  }
  return slope;
}

// By the information of the readings alone. Directions of which nothing is known come out as huge.
double white_error(const Eigen::RowVectorXd& slope, const Eigen::MatrixXd& information) {
  constexpr double ridge = 1e-12;
  Eigen::MatrixXd regular = information;
  for (Eigen::Index i = 0; i < regular.rows(); ++i) {
    regular(i, i) = regular(i, i) * (1.0 + ridge) + 1e-30;
  }
  return std::sqrt(
      std::max(0.0, slope.dot(Eigen::FullPivLU<Eigen::MatrixXd>(regular).solve(slope.transpose()))));
}

// Intervals of figures that hang on several parameters: those of parameters by which each stands for one.
std::vector<LinearInterval> intervals_of(const Eigen::MatrixXd& slopes, const Eigen::MatrixXd& columns,
                                         const FitProblem& problem, const Fit& fit) {
  Eigen::MatrixXd change(columns.cols(), columns.cols());
  change.topRows(slopes.rows()) = slopes;
  change.bottomRows(columns.cols() - slopes.rows()) =
      Eigen::FullPivLU<Eigen::MatrixXd>(slopes).kernel().transpose();
  const Eigen::MatrixXd by_figures = columns * change.inverse();
  return linear_intervals(problem, by_figures, fit.residuals);
}

std::optional<Refusal> not_shown(const Figure& figure, const Estimate& estimate) {
  const double unsure = 0.5 * (estimate.interval.upper - estimate.interval.lower);
  if (unsure <= max_unsure * std::abs(estimate.value)) return std::nullopt;
  return Refusal{"the poses do not show " + std::string(figure.what) + " (" + in_digits(estimate.value, 3) +
                 " +- " + in_digits(unsure, 2) + " at 95 %); add runs with more " + figure.missing};
}

tl::expected<std::array<Estimate, figures.size()>, Refusal> estimates(const FitProblem& problem,
                                                                      const Fit& fit) {
  const Eigen::MatrixXd columns = problem.jacobian(fit.model, fit.residuals);
  const Eigen::MatrixXd information = columns.transpose() * columns;
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(figures.size()), columns.cols());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    slopes.row(static_cast<Eigen::Index>(i)) = slope_of(figures[i], fit.model);
  }
  const auto deviations = intervals_of(slopes, columns, problem, fit);
  std::array<Estimate, figures.size()> found;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const double value = figures[i].of(fit.model);
    const double white =
        deviations_in_ci95 * white_error(slopes.row(static_cast<Eigen::Index>(i)), information);
    found[i] = {value,
                {value + std::min(deviations[i].deviation.lower, -white),
                 value + std::max(deviations[i].deviation.upper, white)}};
    if (auto refusal = not_shown(figures[i], found[i])) return tl::unexpected(*refusal);
  }
  return found;
}

// The likeliest of fits that begin at delays of their own, each paid for by its weights.
Fit best_fit(FitProblem& problem, const TrialModel& start, const Progress& progress) {
  constexpr std::array more_delay_s{0.0, 0.1, 0.2, 0.4};
  constexpr int passes = 2;
  std::optional<Fit> best;
  double least = 0.0;
  for (std::size_t i = 0; i < more_delay_s.size(); ++i) {
    progress("linear model", 0.1 + 0.15 * static_cast<double>(i));
    const Fit fit = problem.fit(more_delay_s[i] > 0.0 ? start.with_later_linear_part(more_delay_s[i]) : start,
                                steps_of_a_fit);
    const double complexity_penalty =
        std::log(static_cast<double>(problem.readings())) * static_cast<double>(fit.model.linear_part.size());
    if (best && fit.sum_squares + complexity_penalty >= least) continue;
    least = fit.sum_squares + complexity_penalty;
    best = fit;
  }
  for (int pass = 0; pass < passes; ++pass) {
    progress("noise", 0.7 + 0.1 * static_cast<double>(pass));
    problem.set_noise(problem.noise_left_by(best->model));
    best = problem.fit(best->model, steps_of_a_fit);
  }
  return *std::move(best);
}

// With the wheel base as a parameter of its own.
TrialModel with_free_wheel_base(TrialModel model) {
  model.effects = {{find_effect("effective_track"), 0, {0.0}}};
  return model;
}

std::optional<Refusal> fault_of(const GatedLog& gated) {
  const auto fault = std::ranges::find_if(gated.faults, &DataFault::explains);
  if (fault == gated.faults.end()) return std::nullopt;
  return Refusal{fault->log + ":" + std::to_string(fault->row) +
                 ": the data contradict themselves: " + fault->what};
}

}  // namespace

WheelFit PoseFit::wheel_fit(const Estimate& gain, bool left) const {
  const double error = standard_deviation(gain.interval);
  WheelFit fit;
  (left ? fit.gain.from_left : fit.gain.from_right) = gain.value;
  (left ? fit.gain_standard_error.from_left : fit.gain_standard_error.from_right) = error;
  fit.position_noise_m = pose_noise_m;
  fit.drift_m_per_sqrt_s = drift_m_per_sqrt_s;
  return fit;
}

bool hold_poses_alone(std::span<const DriveLog> logs) {
  return std::ranges::all_of(
      logs, [](const DriveLog& log) { return !log.has_ticks() && log.has_reference_positions(); });
}

tl::expected<PoseFit, Refusal> fit_from_poses(std::span<const DriveLog> logs, const ParallelFor& parallel_for,
                                              const Progress& progress) {
  if (auto refusal = find_missing_excitation(logs)) return tl::unexpected(*refusal);
  const double period_s = shortest_period_s(logs);
  std::vector<GapRun> runs;
  PoseFit result;
  for (const GatedLog& gated : gate_together(logs)) {
    if (auto refusal = fault_of(gated)) return tl::unexpected(*refusal);
    runs.push_back(make_gap_run(gated.log, gated.flags, period_s));
    measure_motion(runs.back());
    result.poses += runs.back().references.size();
  }
  FitProblem problem(std::move(runs), std::vector<WheelPair>(logs.size()), parallel_for);
  progress("linear model", 0.0);
  const TrialModel start = search_start(problem, nullptr);
  problem.set_noise(problem.noise_left_by(start));
  const Fit fit = best_fit(problem, with_free_wheel_base(start), progress);
  progress("intervals", 0.9);
  const auto found = estimates(problem, fit);
  if (!found) return tl::unexpected(found.error());
  const TravelNoise& noise = problem.noise().channel[static_cast<std::size_t>(Channel::forward)];
  result.linear_part = fit.model.linear();
  result.linear_part.wheel_base_m = wheel_base_m_of(fit.model);
  result.left_gain = (*found)[0];
  result.right_gain = (*found)[1];
  result.lag_s = (*found)[2];
  result.wheel_base_m = (*found)[3];
  result.given_wheel_base_m = logs.front().wheel_base_m;
  result.pose_noise_m = noise.reading;
  result.drift_m_per_sqrt_s = noise.walk_per_sqrt_s;
  return result;
}

}  // namespace wheelwright::gap
