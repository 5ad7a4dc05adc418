// Which order a model needs: held-out free run against cost, for one order after another (the source
// paper: the order is "a balance of accuracy and CPU").
//
// Each order is fitted without the run that it is judged on: every run is held out once (in at most five
// groups), and of a single run the last third. Judged is the free run from rest, in distance: travel of each
// wheel since the start of a block of about 5 s, against the encoders. Blocks, because errors of one free run
// are nearly all correlated: the standard error is that over blocks, or over runs where
// there are at least four. The one-standard-error rule then takes the smallest order that is no more than one
// standard error of the best worse than the best.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "model/identification/refusal.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// A model of one order, and what its fit said of itself (of the worse wheel).
struct OrderTrial {
  LinearModel model;
  double one_step_rms_m_s = 0.0;
  double largest_pole = 0.0;
  double condition = 0.0;
};

// One line of the table. Figures of training are means over the groups.
struct OrderSweepRow {
  std::size_t order = 0;
  double one_step_rms_m_s = 0.0;
  double held_out_distance_rms_m = 0.0;
  double standard_error_m = 0.0;    // of held_out_distance_rms_m
  double largest_pole = 0.0;        // the largest over the groups
  double condition = 0.0;           // the largest over the groups
  std::size_t multiplications = 0;  // per period, for both wheels
  std::optional<Refusal> refusal;   // where this order could not be fitted; the figures are then void
};

struct OrderSweep {
  std::vector<OrderSweepRow> rows;  // orders 1, 2, ...
  std::size_t best = 0;             // order with the smallest held-out error
  std::size_t chosen = 0;           // by the one-standard-error rule
  std::size_t units = 0;            // blocks or runs that the standard error is over
};

using FitOrder = std::function<tl::expected<OrderTrial, Refusal>(std::size_t order)>;
// Makes the fit for one set of training runs, which outlive it.
using FitTraining = std::function<FitOrder(std::span<const DriveLog> training)>;

// Orders 1 to `largest_order`; `on_order`, where given, is called as each begins. Refuses where not a single
// order could be fitted and judged.
tl::expected<OrderSweep, Refusal> sweep_orders(std::span<const DriveLog> logs, std::size_t largest_order,
                                               const std::function<void(std::size_t order)>& on_order,
                                               const FitTraining& fit_training);

}  // namespace wheelwright
