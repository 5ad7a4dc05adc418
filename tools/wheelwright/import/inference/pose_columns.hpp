// Columns without names that hold the pose of the robot: those that go as its counts say it went.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Adds the reference to a mapping with counts of both wheels, if `unused` holds x, y and a heading. Their
// sense of turning shows whether y stands before x, and, unless `sides_are_known`, whether the right wheel
// stands before the left one: then the sides of wheels and commands are exchanged. Places that
// turn with the wheels beside a heading that turns against them: it is clockwise.
void find_pose_columns(const Stream& stream, const std::vector<double>& t_s,
                       const std::vector<const Channel*>& unused, bool sides_are_known, Mapping& mapping,
                       std::vector<std::string>& findings);

}  // namespace wheelwright::import
