// The equations of FIR identification in the integrated domain: wheel travel against delayed commanded
// travel.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <Eigen/Core>

#include "model/drive_log.hpp"

namespace wheelwright {

// Columns come tap by tap, left before right: [left i=0, right i=0, left i=1, ...], so that a shorter
// response is the leading block of the same factorisation. Targets are the travels of the left and the right
// wheel.
using EquationSink =
    std::function<void(const Eigen::RowVectorXd& regressors, const Eigen::RowVector2d& targets)>;

// Noise of a travel reading: white, plus a random walk whose variance grows by `drift_ratio` times the white
// variance each period. The equations handed on are whitened and carry no unknown starting position.
// Returns the sum of log variances of the whitening, which the likelihood of `drift_ratio` needs.
double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 double drift_ratio, const EquationSink& sink);

}  // namespace wheelwright
