// Poses of the reference that its tracker did not measure.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Leaves out, and says: a number in place of a pose that is lost, the last pose again while the robot goes
// on, and single poses of another place or heading (model/log/lost_poses.hpp).
void leave_out_wrong_poses(GateState& gate);

// Leaves out what lies behind a leap that no robot can make: up to the leap back, if the way between the
// poses before and behind is one that the wheels went (as commanded, without counts), and if it comes within
// five seconds; else up to five rows.
void remove_reference_jumps(GateState& gate);

}  // namespace wheelwright::gap
