#include "model/identification/order_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "model/identification/held_out_error.hpp"

namespace wheelwright {
namespace {

constexpr std::size_t max_groups = 5;
constexpr std::size_t runs_for_error_over_runs = 4;

// Runs to train on, and runs to judge by from some time on.
struct Fold {
  std::vector<DriveLog> training;
  std::vector<const DriveLog*> held_out;
  double judged_from_s = 0.0;
};

Fold last_third(const DriveLog& log) {
  Fold fold;
  fold.training.push_back(log);
  auto& kept = fold.training.front().samples;
  fold.judged_from_s = log.samples.front().t_s + (log.samples.back().t_s - log.samples.front().t_s) * 2 / 3;
  std::erase_if(kept, [&](const DriveSample& sample) { return sample.t_s > fold.judged_from_s; });
  fold.held_out.push_back(&log);
  return fold;
}

std::vector<Fold> folds_of(std::span<const DriveLog> logs) {
  if (logs.size() == 1) return {last_third(logs.front())};
  std::vector<Fold> folds(std::min(logs.size(), max_groups));
  for (std::size_t run = 0; run < logs.size(); ++run) {
    for (std::size_t group = 0; group < folds.size(); ++group) {
      if (run % folds.size() == group) {
        folds[group].held_out.push_back(&logs[run]);
        folds[group].judged_from_s = -1.0;
      } else {
        folds[group].training.push_back(logs[run]);
      }
    }
  }
  return folds;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// The held-out error of one order as it comes together.
class Judgement {
 public:
  void add(const OrderTrial& trial, const Fold& fold, bool by_runs) {
    for (const DriveLog* log : fold.held_out) {
      const auto blocks = block_distance_squares(trial.model, *log, fold.judged_from_s);
      if (by_runs && !blocks.empty()) squares_.push_back(mean(blocks));
      if (!by_runs) squares_.insert(squares_.end(), blocks.begin(), blocks.end());
    }
    one_step_.push_back(trial.one_step_rms_m_s);
    row_.largest_pole = std::max(row_.largest_pole, trial.largest_pole);
    row_.condition = std::max(row_.condition, trial.condition);
  }

  std::size_t units() const { return squares_.size(); }

  OrderSweepRow row(std::size_t order) {
    row_.order = order;
    row_.one_step_rms_m_s = mean(one_step_);
    const auto count = static_cast<double>(squares_.size());
    const double mean_square = mean(squares_);
    double spread = 0.0;
    for (const double square : squares_) spread += (square - mean_square) * (square - mean_square);
    const double error = std::sqrt(spread / std::max(1.0, count - 1.0) / count);
    row_.held_out_distance_rms_m = std::sqrt(mean_square);
    // The derivative of a square root carries the error of the mean square over.
    row_.standard_error_m = mean_square > 0.0 ? 0.5 * error / std::sqrt(mean_square) : 0.0;
    return row_;
  }

 private:
  OrderSweepRow row_;
  std::vector<double> squares_;
  std::vector<double> one_step_;
};

// The smallest order within one standard error of the best. What rounding to whole ticks leaves in a
// difference of two readings is no reason for a higher order either.
void choose(OrderSweep& sweep, double tick_m) {
  const OrderSweepRow* best = nullptr;
  for (const auto& row : sweep.rows) {
    if (row.refusal) continue;
    if (best == nullptr || row.held_out_distance_rms_m < best->held_out_distance_rms_m) best = &row;
  }
  if (best == nullptr) return;
  sweep.best = best->order;
  const double allowed_m =
      std::max(best->held_out_distance_rms_m + best->standard_error_m, tick_m / std::sqrt(6.0));
  for (const auto& row : sweep.rows) {
    if (row.refusal || row.held_out_distance_rms_m > allowed_m) continue;
    sweep.chosen = row.order;
    return;
  }
}

}  // namespace

tl::expected<OrderSweep, Refusal> sweep_orders(std::span<const DriveLog> logs, std::size_t largest_order,
                                               const std::function<void(std::size_t order)>& on_order,
                                               const FitTraining& fit_training) {
  const auto folds = folds_of(logs);
  std::vector<FitOrder> fits;
  fits.reserve(folds.size());
  for (const auto& fold : folds) fits.push_back(fit_training(fold.training));
  OrderSweep sweep;
  for (std::size_t order = 1; order <= largest_order; ++order) {
    if (on_order) on_order(order);
    Judgement judgement;
    std::optional<Refusal> refusal;
    for (std::size_t i = 0; i < folds.size() && !refusal; ++i) {
      const auto trial = fits[i](order);
      if (!trial) {
        refusal = trial.error();
      } else {
        judgement.add(*trial, folds[i], logs.size() >= runs_for_error_over_runs);
      }
    }
    if (!refusal && judgement.units() == 0)
      refusal = Refusal{"nothing is left to judge by; record a longer run"};
    OrderSweepRow row;
    row.order = order;
    if (!refusal) row = judgement.row(order);
    row.refusal = refusal;
    const std::size_t weights = 2 * (order + 1) + order;
    row.multiplications = 2 * weights;
    sweep.rows.push_back(row);
    sweep.units = std::max(sweep.units, judgement.units());
  }
  choose(sweep, 0.5 * (logs.front().metres_per_tick->left + logs.front().metres_per_tick->right));
  if (sweep.chosen == 0) {
    const Refusal none{"no order could be fitted"};
    return tl::unexpected(sweep.rows.empty() ? none : *sweep.rows.front().refusal);
  }
  return sweep;
}

}  // namespace wheelwright
