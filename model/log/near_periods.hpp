// Runs of one robot whose rows do not come equally often.
//
// A model is run on periods of its own; commands of a log are averaged over them, which keeps the moment of
// each change, and measurements are compared at their own times. What a period changes of the robot is how
// long commands and readings wait for the next one: half a period on average, which is a part of the delay.
// Periods are near where that part differs by less than a delay that is of interest: 5 ms, or a quarter of
// a period.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/log/drive_log.hpp"

namespace wheelwright {

bool are_near_periods(double one_s, double other_s);

// "its period is 0.054 s, but that of the model is 0.018 s".
std::string different_periods(double period_s, const std::string& other, double other_s);

// Of a model of all these runs: a longer one would smear the commands of those that have more.
double shortest_period_s(std::span<const DriveLog> logs);

// One line on two runs whose periods are not near, with what would be right; nothing where all are.
std::optional<std::string> find_far_period(std::span<const DriveLog> logs);

}  // namespace wheelwright
