#include "model/gap/selection/left_out_runs.hpp"

#include <Eigen/Core>
#include <cmath>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

// The rows of the residuals that belong to one run; they follow each other.
struct Rows {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

std::vector<Rows> rows_of_runs(const FitProblem& problem) {
  std::vector<Rows> rows(problem.runs().size());
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    Rows& of_run = rows[indices[i].run];
    if (of_run.count++ == 0) of_run.first = static_cast<Eigen::Index>(i);
  }
  return rows;
}

double sum_squares_of_rows(const std::vector<double>& residuals, const Rows& rows) {
  return Eigen::Map<const Eigen::VectorXd>(residuals.data() + rows.first, rows.count).squaredNorm();
}

// Of the parameters of one effect.
struct Parameters {
  std::size_t first;
  std::size_t count;
};

Parameters parameters_of(const TrialModel& model, std::size_t effect) {
  Parameters of{model.linear_part.size(), model.effects[effect].parameters.size()};
  for (std::size_t i = 0; i < effect; ++i) of.first += model.effects[i].parameters.size();
  return of;
}

TrialModel stepped(const TrialModel& model, const Parameters& of, const Eigen::VectorXd& step) {
  TrialModel moved = model;
  for (std::size_t i = 0; i < of.count; ++i)
    moved.set_parameter(of.first + i, model.parameter(of.first + i) + step(static_cast<Eigen::Index>(i)));
  return moved;
}

}  // namespace

double left_out_runs_gain_nats(const FitProblem& problem, const Fit& without, const Fit& with,
                               std::size_t effect) {
  if (problem.runs().size() < 2) return 0.0;
  constexpr double ridge = 1e-9;  // of the diagonal: a parameter of which the others say nothing stays
  const Parameters of = parameters_of(with.model, effect);
  const std::vector<double> residuals = problem.residuals(with.model);
  const Eigen::Map<const Eigen::VectorXd> residual(residuals.data(),
                                                   static_cast<Eigen::Index>(residuals.size()));
  const Eigen::MatrixXd columns =
      problem.jacobian(with.model, residuals, problem.outputs_of(with.model.effects[effect]))
          .middleCols(static_cast<Eigen::Index>(of.first), static_cast<Eigen::Index>(of.count));
  const Eigen::MatrixXd information = columns.transpose() * columns;
  const Eigen::VectorXd slope = columns.transpose() * residual;
  double gain = 0.0;
  for (const Rows& run : rows_of_runs(problem)) {
    const auto of_run = columns.middleRows(run.first, run.count);
    Eigen::MatrixXd others = information - of_run.transpose() * of_run;
    others.diagonal() += (ridge * information.diagonal().array() + 1e-30).matrix();
    const Eigen::VectorXd step =
        solve_symmetric(others, of_run.transpose() * residual.segment(run.first, run.count) - slope);
    if (!step.allFinite()) return 0.0;
    gain += 0.5 * (sum_squares_of_rows(without.residuals, run) -
                   sum_squares_of_rows(problem.residuals(stepped(with.model, of, step)), run));
  }
  return std::isfinite(gain) ? gain : 0.0;
}

}  // namespace wheelwright::gap
