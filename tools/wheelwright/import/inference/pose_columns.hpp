// Columns without names that hold the pose of the robot: those that go as its counts say it went.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording.hpp"

namespace wheelwright::import {

// Adds the reference to a mapping with counts of both wheels, where `unused` holds x and y, with or without a
// heading.
void find_pose_columns(const Stream& stream, const std::vector<const Channel*>& unused, Mapping& mapping,
                       std::vector<std::string>& findings);

}  // namespace wheelwright::import
