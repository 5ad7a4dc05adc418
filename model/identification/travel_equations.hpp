// The equations of FIR identification in the integrated domain: wheel travel against delayed commanded
// travel.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <Eigen/Core>

#include "model/identification/travel_whitener.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

// Columns come tap by tap, left before right: [left i=0, right i=0, left i=1, ...], so that a shorter
// response is the leading block of the same factorisation. Targets are the travels of the left and the right
// wheel.
using EquationSink =
    std::function<void(const Eigen::RowVectorXd& regressors, const Eigen::RowVector2d& targets)>;

// The equations handed on are whitened and carry no unknown starting position. Returns the sum of log
// variances of the whitening, which the likelihood of `noise` needs.
double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 const RelativeTravelNoise& noise, const EquationSink& sink);

}  // namespace wheelwright
