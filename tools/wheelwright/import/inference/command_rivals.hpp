// Commands of one kind in several streams, or columns of one: what a planner asked for, and what the robot
// was sent in the end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Takes those of all that explain the wheels best, in place of the first by name; a line in
// `findings`. Commands that are given stay.
void choose_among_commands(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                           std::vector<std::string>& findings);

}  // namespace wheelwright::import
