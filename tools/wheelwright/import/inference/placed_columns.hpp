// Columns without names that may hold the pose of a robot, without the poses that a tracker lost.
#pragma once

#include <optional>
#include <vector>

#include "tools/wheelwright/import/inference/quaternion_columns.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct PlacedColumns {
  std::vector<Channel> cleaned;        // copies; empty of more columns than a pose has beside a few others
  std::vector<const Channel*> unused;  // these copies, or the columns themselves, but for the quaternion's
};

// Rows in which a pose is lost are not-a-number: any two columns that say the same number there
// (model/log/lost_poses.hpp), whatever does not change meanwhile, and the heading of the quaternion.
PlacedColumns placed_columns(const std::vector<const Channel*>& columns,
                             std::optional<QuaternionColumns>& quaternion);

}  // namespace wheelwright::import
