// The equations of FIR identification in the integrated domain: wheel travel against delayed commanded
// travel.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "model/drive_log.hpp"

namespace wheelwright {

// Columns come tap by tap, left before right: [left i=0, right i=0, left i=1, ...], so that a shorter
// response is the leading block of the same factorisation. Targets are the travels of the left and the right
// wheel.
using EquationSink =
    std::function<void(const Eigen::RowVectorXd& regressors, const Eigen::RowVector2d& targets)>;

// Noise of a travel reading, in units of its white part: white, plus a wander that grows like a random walk
// at first and fades later. Where the wander fades (wheel ripple, a speed controller that catches up), travel
// over long times is more exact than a random walk (slip) would leave it. A robot that refreshes its sensors
// on a clock of its own adds the age of each reading times the speed.
struct TravelNoise {
  double drift_ratio = 0.0;  // growth of the wander's variance per period, in variances of the white part
  double memory_periods = std::numeric_limits<double>::infinity();  // in which it fades by e; infinite: never
  // Commanded speed at which the unknown age of a reading doubles the white variance; infinite: ages are
  // alike.
  double age_speed_m_s = std::numeric_limits<double>::infinity();
};

// The equations handed on are whitened and carry no unknown starting position. Returns the sum of log
// variances of the whitening, which the likelihood of `noise` needs.
double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 const TravelNoise& noise, const EquationSink& sink);

}  // namespace wheelwright
