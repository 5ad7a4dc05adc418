#include "model/gap/fit/parameter_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/gap/fit/block_bootstrap.hpp"
#include "model/gap/fit/likelihood_roughness.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright::gap {
namespace {

constexpr double block_s = 3.0;       // longer than the residuals are correlated
constexpr double min_blocks = 20.0;   // shorter blocks rather than fewer
constexpr double max_blocks = 200.0;  // longer ones rather than more
constexpr std::size_t draws = 1000;
constexpr std::uint64_t seed = 1;

double length_of_blocks_s(const FitProblem& problem) {
  double total_s = 0.0;
  for (const GapRun& run : problem.runs()) total_s += run.duration_s();
  return std::clamp(block_s, total_s / max_blocks, total_s / min_blocks);
}

std::vector<BlockSums> sums_of_blocks(const FitProblem& problem, const Eigen::MatrixXd& columns,
                                      const std::vector<double>& residuals) {
  const double length_s = length_of_blocks_s(problem);
  std::map<std::pair<std::size_t, std::size_t>, BlockSums> blocks;
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double time_s = problem.runs()[indices[i].run].period_s * static_cast<double>(indices[i].period);
    BlockSums& block = blocks[{indices[i].run, static_cast<std::size_t>(time_s / length_s)}];
    if (block.gradient.size() == 0) {
      block = {Eigen::MatrixXd::Zero(columns.cols(), columns.cols()), Eigen::VectorXd::Zero(columns.cols())};
    }
    const Eigen::VectorXd row = columns.row(static_cast<Eigen::Index>(i)).transpose();
    block.information.noalias() += row * row.transpose();
    block.gradient += residuals[i] * row;
  }
  std::vector<BlockSums> result;
  result.reserve(blocks.size());
  for (auto& [key, block] : blocks) result.push_back(std::move(block));
  return result;
}

// The derivatives, without those by an effect's parameter that differ from one side to the other. Where a
// command is rounded the other way there is a change to one side, which is no slope.
Eigen::MatrixXd derivatives_to_both_sides(const FitProblem& problem, const Fit& fit) {
  constexpr double unlike = 0.5;  // of the squares: one is nearly four times the other, or they do not agree
  Eigen::MatrixXd columns = problem.jacobian(fit.model, fit.residuals);
  const Eigen::Map<const Eigen::VectorXd> here(fit.residuals.data(), columns.rows());
  for (std::size_t i = fit.model.linear_part.size(); i < fit.model.parameter_count(); ++i) {
    TrialModel moved = fit.model;
    moved.set_parameter(i, fit.model.parameter(i) - small_step(fit.model, i));
    const double by = fit.model.parameter(i) - moved.parameter(i);
    if (by == 0.0) continue;
    const std::vector<double> residuals = problem.residuals(moved);
    const Eigen::Map<const Eigen::VectorXd> there(residuals.data(), columns.rows());
    auto column = columns.col(static_cast<Eigen::Index>(i));
    const Eigen::VectorXd other = (here - there) / by;
    if ((column - other).squaredNorm() > unlike * (column.squaredNorm() + other.squaredNorm()))
      column.setZero();
  }
  return columns;
}

}  // namespace

std::vector<LinearInterval> linear_intervals(const FitProblem& problem, const Eigen::MatrixXd& columns,
                                             const std::vector<double>& residuals) {
  const auto blocks = sums_of_blocks(problem, columns, residuals);
  const Bootstrap bootstrap = block_bootstrap(blocks, draws, seed);
  std::vector<LinearInterval> intervals;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    std::vector<double> sorted(bootstrap.deviations.row(i).begin(), bootstrap.deviations.row(i).end());
    std::ranges::sort(sorted);
    const double white = deviations_in_ci95 * bootstrap.white_deviations(i);
    const auto tail = static_cast<std::size_t>(0.025 * static_cast<double>(draws));
    intervals.push_back({{std::min(sorted[tail], -white), std::max(sorted[draws - 1 - tail], white)},
                         bootstrap.white_deviations(i)});
  }
  return intervals;
}

FitWithIntervals with_effect_intervals(const FitProblem& problem, Fit fit, int steps,
                                       const ParallelFor& parallel_for) {
  constexpr int max_rounds = 3;
  FitWithIntervals result{std::move(fit), {}};
  for (int round = 0; round < max_rounds && !result.fit.model.effects.empty(); ++round) {
    const Eigen::MatrixXd columns = derivatives_to_both_sides(problem, result.fit);
    const auto linear = linear_intervals(problem, columns, result.fit.residuals);
    const double roughness = likelihood_roughness(problem, result.fit, columns);
    Profiles profiles = profile_intervals(problem, result.fit, columns, linear, roughness, parallel_for);
    result.intervals = std::move(profiles.intervals);
    if (!profiles.likelier || round + 1 == max_rounds) break;
    result.fit = problem.fit(*profiles.likelier, steps);
  }
  return result;
}

}  // namespace wheelwright::gap
