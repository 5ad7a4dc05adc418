#include "model/gap/fit/profile_intervals.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "model/statistics/confidence.hpp"
#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

constexpr double chi_squared_95 = deviations_in_ci95 * deviations_in_ci95;
constexpr int max_steps_of_others = 5;
constexpr double worth_a_step = 0.02;  // of the sum of squares
constexpr int max_doublings = 30;
constexpr int halvings = 4;
constexpr double a_nat = 2.0;         // of the sum of squares
constexpr double first_share = 0.02;  // of the usual size, where nothing is known
constexpr std::array shares_of_length{1.0, -1.0, 0.5, -0.5};
constexpr std::array shares_of_deviation{4.0, -4.0, 2.0, -2.0, 1.0, -1.0, 0.5, -0.5};
constexpr int halvings_of_search = 12;
constexpr int max_moves = 8;
constexpr double nearly = 0.9;  // of chi squared: where the slopes are right

std::vector<std::size_t> others_of_the_same_effect(const TrialModel& model, std::size_t parameter) {
  std::vector<std::size_t> others;
  std::size_t first = model.linear_part.size();
  for (const TrialEffect& effect : model.effects) {
    const std::size_t last = first + effect.parameters.size();
    for (std::size_t i = first; i < last && first <= parameter && parameter < last; ++i) {
      if (i != parameter) others.push_back(i);
    }
    first = last;
  }
  return others;
}

struct Point {
  TrialModel model;
  double sum_squares = 0.0;
};

// The likelihood with one parameter held, and the others as good as they can be.
class Profile {
 public:
  Profile(const FitProblem& problem, const Fit& fit, const Eigen::MatrixXd& columns,
          const Eigen::MatrixXd& information, std::span<const LinearInterval> linear, std::size_t held)
      : problem_(problem), fit_(fit), columns_(columns), linear_(linear), held_(held) {
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      if (i != static_cast<Eigen::Index>(held)) free_.push_back(i);
    }
    Eigen::MatrixXd of_others = information(free_, free_);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double size = typical_size(fit.model, static_cast<std::size_t>(free_[i]));
      const auto at = static_cast<Eigen::Index>(i);
      of_others(at, at) += 1.0 / (size * size);
    }
    inverse_ =
        solve_symmetric_columns(of_others, Eigen::MatrixXd::Identity(of_others.rows(), of_others.cols()));
    tradable_ = others_of_the_same_effect(fit.model, held);
    going_with_it_ = -inverse_ * information(free_, static_cast<Eigen::Index>(held));
  }

  // Whether the parameter is unlikely to have this value. An edge shows only where it is crossed, so that
  // what another edge has to do with it must be predicted, by slopes or by trying; what cannot be predicted
  // may be found on the way.
  bool excludes(double value, double chi_squared) {
    return !reaches(moved_to(value, false), chi_squared) && !reaches(moved_to(value, true), chi_squared) &&
           !reaches(traded_for(value), chi_squared);
  }

  const std::optional<Point>& best() const { return best_; }

 private:
  bool reaches(const TrialModel& start, double chi_squared) {
    Point point = with_others_fitted(start, fit_.sum_squares + chi_squared);
    if (point.sum_squares - fit_.sum_squares >= chi_squared) return false;
    if (point.sum_squares < (best_ ? best_->sum_squares : fit_.sum_squares - a_nat)) best_ = point;
    nearest_ = std::move(point.model);
    return true;
  }

  // From the nearest that was not excluded; `predicted`: the others go with it as by the slopes.
  TrialModel moved_to(double value, bool predicted) const {
    TrialModel model = nearest_.value_or(fit_.model);
    const double by = value - model.parameter(held_);
    model.set_parameter(held_, value);
    for (std::size_t i = 0; predicted && i < free_.size(); ++i) {
      const auto parameter = static_cast<std::size_t>(free_[i]);
      model.set_parameter(parameter,
                          model.parameter(parameter) + by * going_with_it_(static_cast<Eigen::Index>(i)));
    }
    return model;
  }

  bool has_slope(std::size_t parameter) const { return linear_[parameter].white_deviation > 0.0; }

  // The changes of another parameter that may make up for the change of the one that is held. Of the same
  // unit: as much or half as much to either side, since to make a thing longer at one end, its middle goes
  // half as far. Of another unit: as much beside what its slopes say it is known to.
  std::vector<double> trades(std::size_t other, double by) const {
    const auto times = [](double unit, std::span<const double> shares) {
      std::vector<double> changes;
      for (const double share : shares) changes.push_back(share * unit);
      return changes;
    };
    if (same_unit(other)) return times(by, shares_of_length);
    const double by_deviations = by / linear_[held_].white_deviation;
    return times(linear_[other].white_deviation * by_deviations, shares_of_deviation);
  }

  bool same_unit(std::size_t other) const {
    return fit_.model.parameter_info(other)->unit == fit_.model.parameter_info(held_)->unit;
  }

  // With another parameter of the same effect elsewhere, wherever that is best.
  TrialModel traded_for(double value) const {
    const TrialModel start = moved_to(value, false);
    const double by = value - nearest_.value_or(fit_.model).parameter(held_);
    Point best{start, std::numeric_limits<double>::infinity()};
    for (const std::size_t other : tradable_) {
      const bool by_slopes = same_unit(other) || (has_slope(other) && has_slope(held_));
      if (!by_slopes) {
        keep_better(best, searched(start, other));
        continue;
      }
      for (const double change : trades(other, by)) keep_better(best, changed(start, other, change));
    }
    return best.model;
  }

  static void keep_better(Point& best, Point point) {
    if (point.sum_squares < best.sum_squares) best = std::move(point);
  }

  Point changed(const TrialModel& start, std::size_t parameter, double by) const {
    Point point{start, 0.0};
    point.model.set_parameter(parameter, start.parameter(parameter) + by);
    point.sum_squares = sum_squares_of(problem_.residuals(point.model));
    return point;
  }

  // Where no slope leads: to either side by ever smaller steps, for as long as that is better.
  Point searched(const TrialModel& start, std::size_t parameter) const {
    Point best = changed(start, parameter, 0.0);
    double step = 0.5 * typical_size(start, parameter);
    for (int halving = 0; halving < halvings_of_search; ++halving, step *= 0.5) {
      for (const double side : {step, -step}) {
        for (int i = 0; i < max_moves; ++i) {
          Point next = changed(best.model, parameter, side);
          if (next.sum_squares >= best.sum_squares) break;
          best = std::move(next);
        }
      }
    }
    return best;
  }

  // By the slopes at the estimate, as far as they lead down; no further than is asked for.
  Point with_others_fitted(const TrialModel& start, double low_enough) const {
    std::vector<double> residuals = problem_.residuals(start);
    Point best{start, sum_squares_of(residuals)};
    double share = 1.0;
    for (int step = 0; step < max_steps_of_others && best.sum_squares >= low_enough; ++step) {
      const Eigen::Map<const Eigen::VectorXd> left(residuals.data(), columns_.rows());
      const Eigen::VectorXd change = inverse_ * (columns_.transpose() * left)(free_);
      Point next{best.model, 0.0};
      for (std::size_t i = 0; i < free_.size(); ++i) {
        const auto parameter = static_cast<std::size_t>(free_[i]);
        next.model.set_parameter(
            parameter, best.model.parameter(parameter) - share * change(static_cast<Eigen::Index>(i)));
      }
      if (!next.model.stable()) break;
      std::vector<double> there = problem_.residuals(next.model);
      next.sum_squares = sum_squares_of(there);
      if (next.sum_squares > best.sum_squares - worth_a_step) {
        share *= 0.5;
        continue;
      }
      best = std::move(next);
      residuals = std::move(there);
    }
    return best;
  }

  const FitProblem& problem_;
  const Fit& fit_;
  const Eigen::MatrixXd& columns_;
  std::span<const LinearInterval> linear_;
  std::size_t held_;
  std::vector<Eigen::Index> free_;  // the other parameters
  std::vector<std::size_t> tradable_;
  Eigen::MatrixXd inverse_;            // of their information
  Eigen::VectorXd going_with_it_;      // by how much each changes for a unit of the one that is held
  std::optional<TrialModel> nearest_;  // that was not excluded so far
  std::optional<Point> best_;          // likelier than the fit
};

// From the estimate outwards, doubled until it is excluded or no further is possible, then halved between.
double end_of(Profile& profile, double estimate, double first_deviation, double bound, double chi_squared) {
  const double direction = bound < estimate ? -1.0 : 1.0;
  const double most = std::abs(bound - estimate);
  double inside = 0.0;
  double outside = std::min(first_deviation, most);
  for (int doubling = 0; doubling < max_doublings; ++doubling) {
    if (profile.excludes(estimate + direction * outside, chi_squared)) break;
    if (outside == most) return bound;
    inside = outside;
    outside = std::min(2.0 * outside, most);
  }
  for (int halving = 0; halving < halvings; ++halving) {
    const double middle = 0.5 * (inside + outside);
    (profile.excludes(estimate + direction * middle, chi_squared) ? outside : inside) = middle;
  }
  return estimate + direction * outside;
}

}  // namespace

Profiles profile_intervals(const FitProblem& problem, const Fit& fit, const Eigen::MatrixXd& columns,
                           std::span<const LinearInterval> linear, double roughness,
                           const ParallelFor& parallel_for) {
  const std::size_t first = fit.model.linear_part.size();
  const std::size_t count = fit.model.parameter_count() - first;
  const Eigen::MatrixXd information = columns.transpose() * columns;
  std::vector<ParameterInterval> intervals(count);
  std::vector<std::optional<Point>> met(2 * count);
  parallel_for(2 * count, [&](std::size_t job) {
    const std::size_t parameter = first + job / 2;
    const bool lower = job % 2 == 0;
    const ParameterInfo& info = *fit.model.parameter_info(parameter);
    const ParameterInterval& by_slope = linear[parameter].deviation;
    const double deviation = lower ? -by_slope.lower : by_slope.upper;
    const double white = deviations_in_ci95 * linear[parameter].white_deviation;
    const double scatter = white > 0.0 ? std::max(1.0, deviation / white) : 1.0;
    const double estimate = fit.model.parameter(parameter);
    const double bound = lower ? info.lower : info.upper;
    double end = std::clamp(estimate + (lower ? -deviation : deviation), info.lower, info.upper);
    Profile profile(problem, fit, columns, information, linear, parameter);
    const double chi_squared = chi_squared_95 * scatter * scatter + roughness;
    if (end != bound && (white == 0.0 || !profile.excludes(end, nearly * chi_squared))) {
      const double begin = white > 0.0 ? 2.0 * deviation : first_share * typical_size(fit.model, parameter);
      end = end_of(profile, estimate, begin, bound, chi_squared);
    }
    (lower ? intervals[job / 2].lower : intervals[job / 2].upper) = end;
    met[job] = profile.best();
  });
  const auto sum_squares = [](const std::optional<Point>& point) {
    return point ? point->sum_squares : std::numeric_limits<double>::infinity();
  };
  const auto best = std::ranges::min_element(met, {}, sum_squares);
  Profiles result{std::move(intervals), std::nullopt};
  if (best != met.end() && *best) result.likelier = (*best)->model;
  return result;
}

}  // namespace wheelwright::gap
