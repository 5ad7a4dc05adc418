// Identification of the moving-average (FIR) model from drive logs.
//
// The paper derives the impulse response from the step response by differentiation (eq. 2-7). With 0.44 mm
// encoder ticks and a sensor refresh that beats against the poll, a difference of counts is mostly noise. So
// the same quantity is estimated in the integrated domain: wheel travel is the impulse response convolved
// with the commanded distance, a linear least-squares problem in the responses, in which counts enter
// undifferenced. For a step this is the derivative of the averaged step response; it holds for any other
// drive as well.
//
//   * Noise: white in position plus a random walk (slip) that may fade (ripple); their ratio and the memory
//     of the walk are chosen by likelihood, and rows are whitened by the Kalman filter of that noise, which
//     leaves independent equations.
//   * Prior: responses decay and are smooth ("tuned/correlated" kernel, Chen, Ohlsson & Ljung, Automatica 48
//     (2012) 1525-1535); its size and decay are chosen by marginal likelihood, so exact data are not shrunk.
//   * Length: from the data, as long as the tail is worth it, and at most two thirds of the longest run.
//     Taps that the response does not need make all of it uncertain, so the search begins with few.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "model/identification/refusal.hpp"
#include "model/identification/response_prior.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/wheel_fit.hpp"

namespace wheelwright {

struct FirFitOptions {
  std::optional<std::size_t> length = {};  // periods; found from the data where absent
  std::size_t first_bound = 40;            // periods; of the search, doubled while the response fills it
  std::size_t longest = 40;                // periods, the last bound
  std::optional<double> period_s = {};     // of the model; that of the first log where absent
};

struct FirFit {
  LinearModel model;
  WheelFit left;
  WheelFit right;
  ResponsePrior prior;   // as the data chose it
  std::size_t rows = 0;  // samples used
  bool cut = false;      // the response fills nine tenths of the last bound: the robot's own goes on
};

// Fits all runs together. Runs start from rest; after a gap in time, the first samples, whose past is
// unknown, are left out. Refuses, with the reason, where the data cannot show the responses.
tl::expected<FirFit, Refusal> fit_fir(std::span<const DriveLog> logs, const FirFitOptions& options = {});

}  // namespace wheelwright
