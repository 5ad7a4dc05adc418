// Parts of a stream in which its clock goes forward: behind a restart or a setting back another one begins.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wheelwright::import {

// Rows with a finite time in the order of time, rows of one time as they stand.
using SessionRows = std::vector<std::size_t>;

// A clock goes back where a stamp lies below the latest before it by more than a second and six usual steps;
// rows that are late by less are sorted. Rows without a time are in no session.
std::vector<SessionRows> clock_sessions(std::span<const double> t_s);

}  // namespace wheelwright::import
