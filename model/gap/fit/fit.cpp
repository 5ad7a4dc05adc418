// How residuals follow the parameters, and the fit that goes down that slope.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "model/gap/fit/problem.hpp"

namespace wheelwright::gap {
namespace {

double damping_floor(const Eigen::MatrixXd& information, Eigen::Index i) {
  return information(i, i) > 0.0 ? information(i, i) : 1.0;
}

// Of all columns with each other, and with what is left.
struct Products {
  Eigen::MatrixXd of_columns;
  Eigen::VectorXd with_residuals;
};

// Those of another part are empty and not worth multiplying.
std::vector<Eigen::Index> filled_columns(const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> filled;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    if (!columns.col(i).isZero(0.0)) filled.push_back(i);
  }
  return filled;
}

// In slices of rows, whose sums do not depend on how many of them are worked on at once.
Products products_of(const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                     const ParallelFor& parallel_for) {
  constexpr Eigen::Index slice_rows = 4096;
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
  return all;
}

TrialModel moved(const TrialModel& model, const Eigen::VectorXd& step) {
  TrialModel result = model;
  for (std::size_t i = 0; i < model.parameter_count(); ++i) {
    result.set_parameter(i, model.parameter(i) + step(static_cast<Eigen::Index>(i)));
  }
  return result;
}

}  // namespace

// Where every wheel answers for itself, as most do, what is moved of one leaves the counts of the other as
// they are: then both are moved in one free run. Whether it is so, the first parameter of each wheel shows.
Eigen::MatrixXd Problem::jacobian(const TrialModel& model, const std::vector<double>& residuals,
                                  Part part) const {
  const std::size_t count = model.parameter_count();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(count));
  const auto fill = [&](const std::vector<MovedAtOnce>& all) {
    parallel_for_(all.size() * runs_.size(), [&](std::size_t job) {
      fill_columns(model, residuals, all[job / runs_.size()], job % runs_.size(), columns);
    });
  };
  const auto asked_for = [&](std::size_t parameter) {
    return part == Part::all || part_of_parameter(model, parameter) == part;
  };
  const std::size_t per_wheel = model.shape.per_wheel();
  std::vector<MovedAtOnce> rest;
  std::size_t next = 0;
  if (!parts_touch_ && !model.shape.shared && asked_for(0)) {
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

bool Problem::shows_only_in(const Eigen::MatrixXd& columns, std::size_t column, Channel channel) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].channel != channel &&
        columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)) != 0.0) {
      return false;
    }
  }
  return true;
}

void Problem::fill_columns(const TrialModel& model, const std::vector<double>& residuals,
                           const MovedAtOnce& at_once, std::size_t run, Eigen::MatrixXd& columns) const {
  TrialModel changed = model;
  for (const auto& moved : at_once) {
    changed.set_parameter(moved.parameter,
                          model.parameter(moved.parameter) + small_step(model, moved.parameter));
  }
  const Part touched = part_of_parameter(model, at_once.front().parameter);
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

Fit Problem::fit(const TrialModel& start, int max_steps, Part part) const {
  constexpr double worth_a_step = 0.2;  // of the sum of squares: a tenth of a nat
  Fit best{start, 0.0, residuals(start, part), {}};
  best.sum_squares = sum_squares_of(best.residuals);
  double damping = 1e-3;
  for (int step = 0; step < max_steps; ++step) {
    const Products products =
        products_of(jacobian(best.model, best.residuals, part), best.residuals, parallel_for_);
    best.information = products.of_columns;
    const double before = best.sum_squares;
    for (int attempt = 0; attempt < 6; ++attempt) {
      Eigen::MatrixXd damped = best.information;
      for (Eigen::Index i = 0; i < damped.rows(); ++i) {
        damped(i, i) += damping * damping_floor(best.information, i);
      }
      const TrialModel candidate = moved(best.model, -damped.ldlt().solve(products.with_residuals));
      if (candidate.stable()) {
        std::vector<double> there = residuals(candidate, part);
        const double sum_squares = sum_squares_of(there);
        if (sum_squares < best.sum_squares) {
          best.model = candidate;
          best.residuals = std::move(there);
          best.sum_squares = sum_squares;
          damping = std::max(1e-7, 0.2 * damping);
          break;
        }
      }
      damping *= 8.0;
    }
    if (before - best.sum_squares < worth_a_step + 1e-5 * before) break;
  }
  if (part != Part::all) {
    best.residuals = residuals(best.model);
    best.sum_squares = sum_squares_of(best.residuals);
  }
  return best;
}

}  // namespace wheelwright::gap
