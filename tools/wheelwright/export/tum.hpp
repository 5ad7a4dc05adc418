// Trajectories in the format of the TUM RGB-D benchmark, which evo reads.
#pragma once

#include <optional>
#include <string>

#include "tools/wheelwright/export/recorded_run.hpp"

namespace wheelwright::tools {

enum class WhichPose { best, model, odometry, hybrid, reference };

struct TumChoice {
  WhichPose pose = WhichPose::best;  // best: the reference where there is one, else the pose that steers
  std::string during;                // of one activity only, as 'route'; empty: of the whole run
};

// One line per pose: `timestamp x y z qx qy qz qw`, in s, m, and a unit quaternion about z. Throws
// DataRefusal where the run holds no such pose.
std::string to_tum(const RecordedRun& run, const TumChoice& choice);

}  // namespace wheelwright::tools
