// Identification of the ARMA (in today's terms ARX) model from drive logs: eq. 1 and 12 of the source paper.
//
// Each wheel is fitted from its own past speeds and both commands, not v and w from theirs. The wheel is
// where the encoder counts, where friction acts and where a fault begins, so that residual, noise and
// standard error belong to one part of the robot; mixing both wheels into v and w would spread each fault
// over both outputs. Nothing is lost: v and w are exact linear combinations of the wheel speeds, and a pole
// of one wheel is a pole of both.
//
// Two methods:
//
// equation_error, the paper's: linear least squares on measured past speeds (ArmaAccumulator). A difference
// of counts is mostly noise (one tick is 24-28 mm/s), and noise on the regressors biases the result.
//
// free_run, the default: starts from there and makes the model's own recursion, fed with commands alone,
// agree with the wheel travel itself, not its differences (free_run_refinement.hpp). This is what the model
// is used for.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "model/identification/fir_fit.hpp"
#include "model/identification/order_sweep.hpp"
#include "model/identification/refusal.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

enum class ArmaMethod { equation_error, free_run };

struct ArmaFitOptions {
  std::optional<std::size_t> order = std::nullopt;  // past speeds; commands reach as far back and include the
                                                    // present one; found by a sweep where absent
  std::size_t largest_order = 15;                   // of the sweep
  std::size_t delay = 0;  // periods in which a command surely does nothing: leading weights fixed at zero
  std::optional<double> period_s = std::nullopt;  // of the model; the shortest of the logs where absent
  ArmaMethod method = ArmaMethod::free_run;
  std::function<void(std::size_t order)> on_order = nullptr;  // called as a sweep comes to an order
};

// What one wheel's fit says of itself.
struct ArmaWheelFit {
  WheelFit quality;               // gain with standard error; noise is that of travel against the free run
  WheelResponse standard_errors;  // one for each weight
  double condition = 0.0;         // of eq. (12), columns scaled alike
  std::size_t rank = 0;  // of eq. (12); below `unknowns` where the order is higher than the data need
  std::size_t unknowns = 0;
  double largest_pole = 0.0;
  double one_step_rms_m_s = 0.0;  // residual of eq. (12) on measured past speeds
};

struct ArmaFit {
  LinearModel model;
  ArmaWheelFit left;
  ArmaWheelFit right;
  std::size_t rows = 0;  // of eq. (12)
  double free_run_distance_rms_m =
      0.0;  // over the known segments of the runs, as model/prediction/score.hpp has it
  std::optional<OrderSweep> sweep;  // where the order was to be found
};

// Fits all runs together. Runs start from rest; rows whose past is not known because of a gap are left out.
// Refuses, with the reason and how to get better data: too few rows, commands that do not tell the weights
// apart, a model that runs away, runs of different robots or periods, values that are no numbers.
tl::expected<ArmaFit, Refusal> fit_arma(std::span<const DriveLog> logs, const ArmaFitOptions& options = {});

}  // namespace wheelwright
