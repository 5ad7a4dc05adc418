// Angles that start again after a turn.
#pragma once

#include <vector>

namespace wheelwright::import {

// Made to go on over the turn: of radians, or of degrees that nobody has said to be such yet.
void unwrap_angles(std::vector<double>& angles);

}  // namespace wheelwright::import
