// Which columns could be commands and wheels: each assignment by how well its commands explain its wheels.
#pragma once

#include <optional>
#include <vector>

#include "tools/wheelwright/import/inference/assignment.hpp"

namespace wheelwright::import {

// Those whose commands explain 60 % of the speed of each wheel, or of the way and the turn of both. `t_s` is
// the time of each row; the wheel base, where it is known, shows a wheel that counts backwards.
std::vector<Assignment> possible_assignments(const std::vector<const Channel*>& commands,
                                             const std::vector<Candidate>& wheels,
                                             const std::vector<double>& t_s,
                                             std::optional<double> wheel_base_m);

// By how many rows a speed, the mean since the row before, is behind a command: half a row of what is
// measured at its row, one and more of what a robot does. At the peak of the correlation, by a parabola.
double rows_behind(const std::vector<double>& speed, const std::vector<double>& command);

// Whether the motion comes so many rows or more after the commands, as it does of a robot: a measured speed
// beside counts goes with them.
bool commands_lead(const Assignment& assignment, const std::vector<double>& t_s, double least_rows);

}  // namespace wheelwright::import
