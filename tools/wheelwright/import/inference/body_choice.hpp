// Which of several tracked bodies is the robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Of a recording whose streams are the poses of several bodies and nothing else ("tag_id 3", "tag_id 7"),
// beside one of the robot: leaves the body whose speed goes with that of the robot at some shift of its
// clock, by a correlation that is larger by 0.1 than that of any other. A line that says so; nothing where
// there is no choice to make or none stands out.
std::optional<std::string> choose_among_bodies(std::vector<Recording>& recordings, const GivenMapping& given);

}  // namespace wheelwright::import
