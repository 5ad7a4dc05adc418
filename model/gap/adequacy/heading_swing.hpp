// A swing of the wheels as a swing of the robot's heading: two wheels that swing by a millimetre against each
// other turn a robot by what a person sees.
#pragma once

#include <span>
#include <vector>

#include "model/gap/adequacy/periodic_residual.hpp"
#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

// Amplitude in rad of (right error - left error) / wheel base, with the period that was found in one of the
// wheels (swing_amplitude.hpp). `at` holds where the readings of that wheel stand, `left` and `right` the
// tracks of both in the order of the runs. 0 where the two have not been read together, and where it is no
// more than the counts of both wheels are coarse, half a count each: at a steady speed their rounding
// repeats.
double heading_swing_rad(const FitProblem& problem, const PeriodicResidual& found,
                         std::span<const ResidualTrack* const> left,
                         std::span<const ResidualTrack* const> right,
                         std::span<const std::vector<double>> at);

}  // namespace wheelwright::gap
