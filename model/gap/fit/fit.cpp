// How residuals follow the parameters, and the fit that goes down that slope.
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/gap/fit/fit_problem.hpp"
#include "model/statistics/levenberg_marquardt.hpp"

namespace wheelwright::gap {
namespace {

// Those of parameters that do not affect these outputs are empty and not worth multiplying.
std::vector<Eigen::Index> filled_columns(const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> filled;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    if (!columns.col(i).isZero(0.0)) filled.push_back(i);
  }
  return filled;
}

// In slices of rows, whose sums do not depend on how many of them are worked on at once.
NormalEquations normal_equations(const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                                 const ParallelFor& parallel_for) {
  constexpr Eigen::Index slice_rows = 4096;
  struct Products {
    Eigen::MatrixXd of_columns;
    Eigen::VectorXd with_residuals;
  };
  const Eigen::Map<const Eigen::VectorXd> residual(residuals.data(), columns.rows());
  const std::vector<Eigen::Index> filled = filled_columns(columns);
  std::vector<Products> slices(static_cast<std::size_t>((columns.rows() + slice_rows - 1) / slice_rows));
  parallel_for(slices.size(), [&](std::size_t i) {
    const Eigen::Index first = static_cast<Eigen::Index>(i) * slice_rows;
    const auto rows = Eigen::seqN(first, std::min(slice_rows, columns.rows() - first));
    const Eigen::MatrixXd some = columns(rows, filled);
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(some.cols(), some.cols());
    lower.selfadjointView<Eigen::Lower>().rankUpdate(some.transpose());
    slices[i] = {lower, some.transpose() * residual(rows)};
  });
  const auto count = static_cast<Eigen::Index>(filled.size());
  Products sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  for (const auto& slice : slices) {
    sum.of_columns += slice.of_columns;
    sum.with_residuals += slice.with_residuals;
  }
  Products all{Eigen::MatrixXd::Zero(columns.cols(), columns.cols()), Eigen::VectorXd::Zero(columns.cols())};
  all.of_columns(filled, filled) = Eigen::MatrixXd(sum.of_columns.selfadjointView<Eigen::Lower>());
  all.with_residuals(filled) = sum.with_residuals;
  return {std::move(all.of_columns), std::move(all.with_residuals)};
}

// The parameters that affect the given outputs, fitted to the residuals of these outputs.
class FitOfOutputs {
 public:
  using Point = Fit;

  FitOfOutputs(const FitProblem& problem, Outputs outputs, const ParallelFor& parallel_for,
               std::vector<char> is_held = {})
      : problem_(problem), outputs_(outputs), parallel_for_(parallel_for), is_held_(std::move(is_held)) {}

  Fit at(const TrialModel& model) const {
    Fit fit{model, 0.0, problem_.residuals(model, outputs_)};
    fit.sum_squares = sum_squares_of(fit.residuals);
    return fit;
  }
  static double objective(const Fit& fit) { return fit.sum_squares; }
  NormalEquations linearise(const Fit& fit) const {
    Eigen::MatrixXd columns = problem_.jacobian(fit.model, fit.residuals, outputs_);
    for (std::size_t i = 0; i < is_held_.size(); ++i) {
      if (is_held_[i] != 0) columns.col(static_cast<Eigen::Index>(i)).setZero();
    }
    return normal_equations(columns, fit.residuals, parallel_for_);
  }
  std::optional<Fit> moved(const Fit& fit, const Eigen::VectorXd& step) const {
    const TrialModel model = fit.model.moved(step);
    if (!model.stable()) return std::nullopt;
    return at(model);
  }

 private:
  const FitProblem& problem_;
  Outputs outputs_;
  const ParallelFor& parallel_for_;
  std::vector<char> is_held_;
};

LevenbergMarquardtRule rule_of(int max_steps) {
  constexpr double worth_a_step = 0.2;  // of the sum of squares: a tenth of a nat
  return {.max_steps = max_steps,
          .min_damping = 1e-7,
          .decrease = 0.2,
          .increase = 8.0,
          .min_fall = worth_a_step};
}

}  // namespace

// Where every wheel answers for itself, as most do, what is moved of one leaves the counts of the other as
// they are: then both are moved in one free run. Whether it is so, the first parameter of each wheel shows.
Eigen::MatrixXd FitProblem::jacobian(const TrialModel& model, const std::vector<double>& residuals,
                                     Outputs outputs) const {
  const std::size_t count = model.parameter_count();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(count));
  const auto fill = [&](const std::vector<MovedAtOnce>& all) {
    parallel_for_(all.size() * runs_.size(), [&](std::size_t job) {
      const MovedAtOnce& at_once = all[job / runs_.size()];
      const std::size_t first = at_once.front().parameter;
      const Outputs shown =
          outputs == Outputs::all ? outputs_shown_by(model, first) : outputs_of_parameter(model, first);
      fill_columns(model, residuals, at_once, job % runs_.size(), shown, columns);
    });
  };
  const auto asked_for = [&](std::size_t parameter) {
    return outputs == Outputs::all || outputs_of_parameter(model, parameter) == outputs;
  };
  const std::size_t per_wheel = model.shape.per_wheel();
  std::vector<MovedAtOnce> rest;
  std::size_t next = 0;
  if (!outputs_are_tied_ && !model.shape.shared && asked_for(0)) {
    fill({{{0, std::nullopt}}, {{per_wheel, std::nullopt}}});
    const bool apart =
        shows_only_in(columns, 0, Channel::left) && shows_only_in(columns, per_wheel, Channel::right);
    for (std::size_t i = 1; i < per_wheel; ++i) {
      if (apart) {
        rest.push_back({{i, Channel::left}, {i + per_wheel, Channel::right}});
      } else {
        rest.push_back({{i, std::nullopt}});
        rest.push_back({{i + per_wheel, std::nullopt}});
      }
    }
    next = 2 * per_wheel;
  }
  for (; next < count; ++next) {
    if (asked_for(next)) rest.push_back({{next, std::nullopt}});
  }
  fill(rest);
  return columns;
}

bool FitProblem::shows_only_in(const Eigen::MatrixXd& columns, std::size_t column, Channel channel) const {
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    if (indices_[i].channel != channel &&
        columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)) != 0.0) {
      return false;
    }
  }
  return true;
}

void FitProblem::fill_columns(const TrialModel& model, const std::vector<double>& residuals,
                              const MovedAtOnce& at_once, std::size_t run, Outputs touched,
                              Eigen::MatrixXd& columns) const {
  TrialModel changed = model;
  for (const auto& moved : at_once) {
    changed.set_parameter(moved.parameter,
                          model.parameter(moved.parameter) + small_step(model, moved.parameter));
  }
  const std::vector<double> there = whitened(run, free_run_errors(changed, runs_[run], touched));
  const std::size_t begin = run_range_[run].first;
  const auto fill = [&](std::size_t first, std::size_t count, const std::optional<Channel>& channel) {
    if (!is_of(touched, channel)) return;
    for (const auto& moved : at_once) {
      if (moved.shows_in && channel != moved.shows_in) continue;
      const double step = small_step(model, moved.parameter);
      auto column = columns.col(static_cast<Eigen::Index>(moved.parameter));
      for (std::size_t i = first; i < first + count; ++i) {
        column(static_cast<Eigen::Index>(i)) = (there[i - begin] - residuals[i]) / step;
      }
    }
  };
  for (const auto& block : blocks_) {
    if (block.run == run) fill(block.offset, block.times_s.size(), static_cast<Channel>(block.channel));
  }
  for (const auto& block : segments_) {
    if (block.run == run) fill(block.offset, 3, std::nullopt);
  }
}

Fit FitProblem::fit(const TrialModel& start, int max_steps, Outputs outputs) const {
  const FitOfOutputs problem(*this, outputs, parallel_for_);
  Fit best = levenberg_marquardt(problem, problem.at(start), rule_of(max_steps));
  if (outputs != Outputs::all) best = FitOfOutputs(*this, Outputs::all, parallel_for_).at(best.model);
  return best;
}

Fit FitProblem::fit_with_held(const TrialModel& start, int max_steps,
                              const std::vector<char>& is_held) const {
  const FitOfOutputs problem(*this, Outputs::all, parallel_for_, is_held);
  return levenberg_marquardt(problem, problem.at(start), rule_of(max_steps));
}

}  // namespace wheelwright::gap
