#include "model/gap/linear_changes/linear_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/adequacy/variance_ratio.hpp"
#include "model/gap/fit/parameter_intervals.hpp"
#include "model/statistics/dense_solve.hpp"
#include "model/statistics/levenberg_marquardt.hpp"

namespace wheelwright::gap {
namespace {

constexpr double smallest_gain_change = 0.01;
constexpr double smallest_delay_s = 0.005;
constexpr double smallest_delay_periods = 0.25;
constexpr double smallest_lag_s = 0.015;
// Of what a change makes, that no other change makes as well: where it is less, as of both gains beside the
// taper of a dead zone, the runs do not show which of them it is.
constexpr double smallest_own_share = 1e-3;
constexpr Eigen::Index parameter_count = 4;
constexpr double prior_information =
    1.0;  // a change by 1 or 1 s is one standard deviation: no run is that vague

using Parameters = Eigen::Matrix<double, parameter_count, 1>;  // left gain, right gain, delay, lag
constexpr std::array<double, parameter_count> steps{1e-3, 1e-3, 2e-3, 2e-3};

CommandCorrection correction_of(const Parameters& p) {
  return {{p(0), p(1)}, p(2), p(3)};
}

bool any_acts(const RobotModel& model, bool EffectInfo::*how) {
  return std::ranges::any_of(model.effects, [&](const AddedEffect& effect) {
    const EffectInfo* info = find_effect(effect.setting.name);
    return info != nullptr && info->*how;
  });
}

// Residuals of one problem as a function of the correction.
class CorrectedRuns {
 public:
  struct Point {
    Parameters parameters;
    std::vector<double> residuals;
    double sum_squares = 0.0;
  };

  CorrectedRuns(const RobotModel& model, const TrialModel& measured, const FitProblem& problem)
      : problem_(problem),
        model_(model),
        lag_s_(lag_of(model.linear_part)),
        reference_lag_s_(measured.reference_lag_s()),
        gyro_scale_(measured.gyro_scale()) {}

  std::vector<double> residuals(const Parameters& p) const { return residuals_of(model_, p); }

  std::vector<double> residuals_of(RobotModel model, const Parameters& p) const {
    const CommandCorrection correction = correction_of(p);
    model.linear_part = corrected(model_.linear_part, correction);
    const MeasuredSimulation simulation{ModelSimulation(model), any_acts(model, &EffectInfo::by_pose),
                                        any_acts(model, &EffectInfo::by_wheel_angle), reference_lag_s_,
                                        gyro_scale_};
    std::vector<RunErrors> errors;
    for (const GapRun& run : problem_.runs()) {
      GapRun driven = run;
      driven.commands_m_s = delayed(run.commands_m_s, correction.delay_s, run.period_s);
      errors.push_back(free_run_errors(simulation, driven));
    }
    return problem_.residuals(errors);
  }

  Eigen::MatrixXd derivatives(const Parameters& p, const std::vector<double>& residuals) const {
    Eigen::MatrixXd columns(static_cast<Eigen::Index>(residuals.size()), parameter_count);
    for (Eigen::Index i = 0; i < parameter_count; ++i) {
      Parameters moved = p;
      moved(i) += steps.at(static_cast<std::size_t>(i));
      const auto there = this->residuals(moved);
      for (std::size_t r = 0; r < residuals.size(); ++r) {
        columns(static_cast<Eigen::Index>(r), i) =
            (there[r] - residuals[r]) / steps.at(static_cast<std::size_t>(i));
      }
    }
    return columns;
  }

  // By all parameters of the effects whose size shows. A gain may be as well the taper of a dead zone.
  Eigen::MatrixXd derivatives_by_effects(const Parameters& p, const std::vector<double>& residuals) const {
    constexpr double share_of_range = 1e-3;
    std::vector<Eigen::VectorXd> columns;
    const Eigen::Map<const Eigen::VectorXd> here(residuals.data(),
                                                 static_cast<Eigen::Index>(residuals.size()));
    for (std::size_t e = 0; e < model_.effects.size(); ++e) {
      const auto infos = parameters_of(model_.effects[e].setting);
      for (std::size_t i = 0; i < infos.size(); ++i) {
        RobotModel moved = model_;
        double& value = moved.effects[e].setting.parameters[i];
        const double size = share_of_range * (infos[i].upper - infos[i].lower);
        const double step = value + size > infos[i].upper ? -size : size;
        value += step;
        const auto there = residuals_of(std::move(moved), p);
        const Eigen::Map<const Eigen::VectorXd> beside(there.data(), here.size());
        Eigen::VectorXd column = (beside - here) / step;
        if (column.squaredNorm() > 0.0) columns.push_back(std::move(column));
      }
    }
    Eigen::MatrixXd all(here.size(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = columns[i];
    return all;
  }

  Point at(const Parameters& p) const {
    Point point{p, residuals(p)};
    point.sum_squares = sum_squares_of(point.residuals);
    return point;
  }
  static double objective(const Point& point) { return point.sum_squares; }
  NormalEquations linearise(const Point& point) const {
    const Eigen::MatrixXd columns = derivatives(point.parameters, point.residuals);
    const Eigen::Map<const Eigen::VectorXd> residual(point.residuals.data(), columns.rows());
    Eigen::MatrixXd information = columns.transpose() * columns;
    information.diagonal().array() += prior_information;
    return {std::move(information), columns.transpose() * residual};
  }
  std::optional<Point> moved(const Point& point, const Eigen::VectorXd& step) const {
    Parameters p = point.parameters + Parameters(step);
    p(3) = std::max(p(3), -0.9 * lag_s_);
    return at(p);
  }

 private:
  const FitProblem& problem_;
  const RobotModel& model_;
  double lag_s_;
  double reference_lag_s_;
  double gyro_scale_;
};

Parameters no_change() {
  return {1.0, 1.0, 0.0, 0.0};
}

// No slope leads over a delay of many periods: the best one on a grid.
Parameters best_delay(const CorrectedRuns& runs, double period_s) {
  Parameters best = no_change();
  double least = sum_squares_of(runs.residuals(best));
  for (double delay_s = std::ceil(-0.15 / period_s) * period_s; delay_s <= 0.6; delay_s += period_s) {
    Parameters p = no_change();
    p(2) = delay_s;
    const double sum_squares = sum_squares_of(runs.residuals(p));
    if (sum_squares >= least) continue;
    least = sum_squares;
    best = p;
  }
  return best;
}

Parameters fitted(const CorrectedRuns& runs, const Parameters& start) {
  const LevenbergMarquardtRule rule{.max_attempts = 5, .min_damping = 1e-7, .increase = 8.0, .min_fall = 0.2};
  return levenberg_marquardt(runs, runs.at(start), rule).parameters;
}

// Of the square of a column, what no sum of the others makes. The others may be collinear.
double own_share(const Eigen::MatrixXd& columns, Eigen::Index which) {
  Eigen::MatrixXd others = columns;
  others.col(which).setZero();
  const Eigen::MatrixXd products = others.transpose() * others;
  Eigen::MatrixXd damped = products;
  for (Eigen::Index i = 0; i < damped.rows(); ++i)
    damped(i, i) += products(i, i) > 0.0 ? 1e-9 * products(i, i) : 1.0;
  const Eigen::VectorXd column = columns.col(which);
  const Eigen::VectorXd made = others * solve_symmetric(damped, others.transpose() * column);
  return (column - made).squaredNorm() / column.squaredNorm();
}

bool leaves_out(const ParameterInterval& interval, double none) {
  return interval.lower > none || interval.upper < none;
}

}  // namespace

LinearChanges linear_changes(const RobotModel& model, const TrialModel& measured, const FitProblem& train,
                             const FitProblem& heldout) {
  const double period_s = model.linear_part.period_s;
  const CorrectedRuns runs(model, measured, train);
  const Parameters p = fitted(runs, best_delay(runs, period_s));
  LinearChanges result;
  result.correction = correction_of(p);

  const CorrectedRuns unseen(model, measured, heldout);
  const auto after = unseen.residuals(p);
  result.heldout_gain_nats = 0.5 * (sum_squares_of(unseen.residuals(no_change())) - sum_squares_of(after)) /
                             variance_ratio(heldout, after);
  if (result.heldout_gain_nats < confirming_nats) return result;

  const auto residuals = runs.residuals(p);
  const Eigen::MatrixXd by_effects = runs.derivatives_by_effects(p, residuals);
  Eigen::MatrixXd columns(by_effects.rows(), parameter_count + by_effects.cols());
  columns << runs.derivatives(p, residuals), by_effects;
  const auto deviations = linear_intervals(train, columns, residuals);
  const auto add = [&](std::string_view what, std::string_view wheel, Eigen::Index i, double none,
                       double smallest, std::string_view unit) {
    const ParameterInterval& deviation = deviations[static_cast<std::size_t>(i)].deviation;
    const ParameterInterval interval{p(i) + deviation.lower, p(i) + deviation.upper};
    if (std::abs(p(i) - none) < smallest || !leaves_out(interval, none)) return;
    if (own_share(columns, i) < smallest_own_share) return;
    result.changes.push_back({what, wheel, p(i), unit, interval});
  };
  add("delay", "both", 2, 0.0, std::max(smallest_delay_s, smallest_delay_periods * period_s), "s");
  add("gain", "left", 0, 1.0, smallest_gain_change, "1");
  add("gain", "right", 1, 1.0, smallest_gain_change, "1");
  add("lag", "both", 3, 0.0, smallest_lag_s, "s");
  return result;
}

std::string in_words(const std::vector<LinearChange>& changes, std::string_view model) {
  std::ostringstream words;
  for (const LinearChange& change : changes) {
    words << (words.view().empty() ? "" : "; ");
    const bool is_gain = change.what == "gain";
    const double scale = is_gain ? 1.0 : 1000.0;
    if (is_gain) {
      words << "the gain of the " << change.wheel << " wheel is " << std::setprecision(4);
    } else {
      words << "the " << change.what << " is " << (change.value > 0.0 ? "longer" : "shorter") << " by "
            << std::setprecision(3);
    }
    const double sign = is_gain || change.value > 0.0 ? 1.0 : -1.0;
    const double one = sign * scale * change.interval.lower;
    const double other = sign * scale * change.interval.upper;
    words << sign * scale * change.value
          << (is_gain ? " times that of " + std::string(model) + " (" : " ms (") << std::min(one, other)
          << " to " << std::max(one, other) << ")";
  }
  return words.str();
}

}  // namespace wheelwright::gap
