// Where commands have been steady for a while: there a robot drifts less from its model than while its speed
// changes, since most of what a model has wrong shows as speed changes.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/pose.hpp"

namespace wheelwright::gap {

// Since when neither wheel's command may have changed by more than a share of the largest one of the run.
constexpr double steady_after_s = 1.0;
constexpr double steady_change = 0.1;

// One for each command: 1 where one within the time before it differs from it by more than that, else 0. A
// run starts from rest.
std::vector<double> unsteady_periods(std::span<const WheelPair> commands_m_s, double period_s);

// The share of unsteady time since the reading before, for each reading; times since the start of the run.
std::vector<double> unsteady_shares(std::span<const double> unsteady_periods, std::span<const double> times_s,
                                    double period_s);

}  // namespace wheelwright::gap
